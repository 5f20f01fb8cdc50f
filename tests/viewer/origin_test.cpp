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

TEST(Origin, BeyondLoopbackNumbersAndTheNameOfThisMachineAreOwn) {
  for (const char* host : {"192.168.0.2:8080", "10.0.0.1", "[fe80::1]:80", "[::1]"})
    EXPECT_TRUE(is_own_host(host)) << host;
  EXPECT_TRUE(is_own_host(host_of("0.0.0.0") + ":8080"));
  for (const char* host : {"", "evil.example", "evil.example:80", "192.168.0.2:x", "[fe80::1",
                           "[fe80::1]x", "1.2.3", "192.168.0.2.evil.example"})
    EXPECT_FALSE(is_own_host(host)) << host;
}

TEST(Origin, AddressesAreNumbersAndSomeAreOfThisMachineAlone) {
  for (const char* address : {"127.0.0.1", "127.1.2.3", "::1"})
    EXPECT_TRUE(is_address(address) && is_loopback_address(address)) << address;
  for (const char* address : {"0.0.0.0", "192.168.0.2", "::", "fe80::1"})
    EXPECT_TRUE(is_address(address) && !is_loopback_address(address)) << address;
  for (const char* address : {"", "localhost", "127.0.0.1:80", "256.0.0.1", "1.2.3"})
    EXPECT_FALSE(is_address(address)) << address;
  EXPECT_EQ(host_of("fe80::1"), "[fe80::1]");
  EXPECT_EQ(host_of("192.168.0.2"), "192.168.0.2");
}

TEST(Origin, TokensDifferAndAreComparedWhole) {
  const std::string a = make_token(), b = make_token();
  EXPECT_EQ(a.size(), 32u);
  EXPECT_EQ(a.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(a, b);
  EXPECT_TRUE(is_same_secret(a, a));
  for (const std::string& other : {b, a.substr(1), a + "0", std::string(), "x" + a.substr(1)})
    EXPECT_FALSE(is_same_secret(other, a)) << other;
}

}  // namespace
}  // namespace thigma::live
