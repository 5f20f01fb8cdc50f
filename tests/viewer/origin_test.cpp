#include "viewer/server/origin.h"

#include <gtest/gtest.h>

namespace thigma::live {
namespace {

TEST(Origin, OnlyLoopbackNamesAreThisMachine) {
  for (const char* host :
       {"127.0.0.1", "127.0.0.1:8080", "localhost:1", "LocalHost", "[::1]:65535"})
    EXPECT_TRUE(is_loopback_host(host)) << host;
  for (const char* host :
       {"", "evil.example", "127.0.0.1.evil.example", "localhost.evil.example:80",
        "127.0.0.1:", "127.0.0.1:80x", "127.0.0.1:123456", "192.168.0.1", "::1", "127.0.0.2",
        "user@127.0.0.1", "127.0.0.1:80@evil.example"})
    EXPECT_FALSE(is_loopback_host(host)) << host;
}

TEST(Origin, OnlyThePageOfTheSameHostAndPortIsOwn) {
  EXPECT_TRUE(is_own_origin("http://127.0.0.1:8080", "127.0.0.1:8080"));
  EXPECT_TRUE(is_own_origin("http://LOCALHOST:8080", "localhost:8080"));
  for (const char* origin :
       {"", "null", "http://127.0.0.1", "http://127.0.0.1:8081", "file://",
        "https://127.0.0.1:8080", "http://localhost:8080", "http://127.0.0.1:8080/",
        "http://127.0.0.1:8080.evil.example", "http://evil.example", "http:/127.0.0.1:8080"})
    EXPECT_FALSE(is_own_origin(origin, "127.0.0.1:8080")) << origin;
  EXPECT_FALSE(is_own_origin("http://", ""));
}

}  // namespace
}  // namespace thigma::live
