#pragma once
// Whether a claims.json is as docs say (experiments/README.md).

#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace thigma::test {

/// Fails the test where it is not.
inline void expect_claims_schema(const nlohmann::json& json, const std::string& name) {
  EXPECT_EQ(json.at("name"), name);
  EXPECT_TRUE(json.at("source").is_string());
  std::set<std::string> ids;
  for (const nlohmann::json& claim : json.at("claims")) {
    EXPECT_TRUE(ids.insert(claim.at("id").get<std::string>()).second)
        << "twice: " << claim.at("id");
    EXPECT_FALSE(claim.at("text").get<std::string>().empty());
    for (const char* key : {"value", "bound"})
      EXPECT_TRUE(claim.at(key).is_number() || claim.at(key).is_null());
    EXPECT_TRUE(claim.at("unit").is_string());
    EXPECT_TRUE(claim.at("holds").is_boolean());
    EXPECT_TRUE(claim.at("expected").is_boolean());
    EXPECT_TRUE(claim.at("reason").is_string());
    if (claim.at("expected").get<bool>()) continue;
    EXPECT_FALSE(claim.at("holds").get<bool>());
    EXPECT_FALSE(claim.at("reason").get<std::string>().empty());
  }
}

}  // namespace thigma::test
