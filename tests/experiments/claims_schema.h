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
    const std::string kind = claim.at("kind");
    EXPECT_TRUE(kind == "checked" || kind == "stated" || kind == "not reproduced") << kind;
    EXPECT_EQ(claim.at("bound").is_null(), kind == "stated");
    EXPECT_FALSE(claim.at("holds").get<bool>() && claim.at("value").is_null());
    if (!claim.at("expected").get<bool>()) {
      EXPECT_EQ(kind, "not reproduced");
      EXPECT_FALSE(claim.at("holds").get<bool>());
    }
    EXPECT_EQ(claim.at("reason").get<std::string>().empty(), kind != "not reproduced");
    if (kind != "not reproduced") continue;
    EXPECT_FALSE(claim.at("sweep").get<std::string>().empty());
    EXPECT_TRUE(claim.at("floor").is_number());
  }
}

}  // namespace thigma::test
