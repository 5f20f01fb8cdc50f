#pragma once
// All claims of a run of `experiment all`, with their kinds, from the files it wrote.

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/common/experiment.h"

namespace thigma::experiments {

/// A Markdown page of folder/NAME/claims.json of these experiments, in their order: how many claims
/// are of each kind; those that are not reproduced with value, bound, floor, sweep and reason; all
/// others. One that has no file is named.
/// Thread   [offline]; InputError for a file that is no claims file.
std::string claim_list(const std::filesystem::path& folder,
                       const std::vector<Experiment>& experiments);

}  // namespace thigma::experiments
