#include "experiments/common/claim_list.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma::experiments {
namespace {

Outcome none(const Context&) { return {}; }

const std::vector<Experiment> kTwo = {{"first", "Fig. 0", "one", none},
                                      {"second", "Fig. 1", "another", none}};

std::filesystem::path folder_with(const std::string& text) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("thigma_claim_list" + std::to_string(::getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "first");
  write_file((folder / "first" / "claims.json").string(), text);
  return folder;
}

TEST(ClaimList, TellsEveryClaimWithItsKindAndWhatWasNotRun) {
  const std::vector<Claim> claims = {
      at_least("good", "is large | or so", 3.0, 2.0, "N"),
      known_not_to(within("known", "lies there", 3.0, 1.0, 2.0),
                   {.reason = "because", .sweep = "data.csv", .floor = 4.0, .floor_low = 0.5}),
      at_most("bad", "is small", 5.0, 2.0), stated("said", "only said", 7.0)};
  const std::string page = claim_list(folder_with(claims_json(kTwo[0], claims)), kTwo);
  EXPECT_NE(
      page.find("4 claims: 2 checked, 1 stated, 1 not reproduced; 1 broken. Not run: second."),
      std::string::npos)
      << page;
  for (const char* row : {"| first | 2 | 1 | 1 | 1 |\n",
                          "| first | known | 3 | 1 to 2 | 0.5 to 4 | data.csv | because |\n",
                          "| first | good | checked | 3 N | 2 | is large \\| or so |\n",
                          "| first | bad | checked, BROKEN | 5 | 2 | is small |\n",
                          "| first | said | stated | 7 |  | only said |\n"})
    EXPECT_NE(page.find(row), std::string::npos) << row << page;
}

TEST(ClaimList, RefusesWhatIsNoClaimsFile) {
  for (const char* text : {"", "{}", "[1]", R"({"counts": {"checked": "x"}, "claims": []})"})
    EXPECT_THROW(claim_list(folder_with(text), kTwo), InputError) << text;
}

}  // namespace
}  // namespace thigma::experiments
