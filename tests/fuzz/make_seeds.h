#pragma once
// Where make_fuzz_seeds writes.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "thigma/files/file.h"

namespace thigma::fuzz {

struct Seeds {
  std::filesystem::path folder;
  void put(const std::string& target, const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(folder / target);
    write_file((folder / target / name).string(), bytes);
  }
};

void put_worlds(const Seeds& seeds);

}  // namespace thigma::fuzz
