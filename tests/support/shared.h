#pragma once
// Where the shared test material lies, and how a test says that it is not there.

#include <cstdlib>
#include <filesystem>
#include <string>

namespace thigma::test {

/// $THIGMA_SHARED, by default ../shared beside the source tree; empty when there is no such folder.
inline std::filesystem::path shared_folder() {
  const char* named = std::getenv("THIGMA_SHARED");
  const std::filesystem::path folder = named ? named : THIGMA_SOURCE_DIR "/../shared";
  return std::filesystem::is_directory(folder / "meshes") ? folder : std::filesystem::path();
}

}  // namespace thigma::test

/// Declares `folder`, or skips the test with a printed reason.
#define THIGMA_NEEDS_SHARED(folder)                                     \
  const std::filesystem::path folder = ::thigma::test::shared_folder(); \
  if ((folder).empty())                                                 \
  GTEST_SKIP() << "needs the shared meshes: set THIGMA_SHARED to the folder that holds meshes/"
