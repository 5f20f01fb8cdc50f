#include "thigma/device/vendor_libraries.h"

#include <cstdio>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(VendorLibraries, ProbeTellsLoadableIncompleteAndMissingApart) {
  const char* const absent[] = {"libthigma_absent.so"};
  const char* const math[] = {"libthigma_absent.so", "libm.so.6"};
  const char* const floor_only[] = {"floor"};
  const char* const more[] = {"floor", "hdBeginFrame"};

  const LibraryProbe missing = probe_library({"", "", absent, floor_only, ""});
  EXPECT_EQ(missing.state, LibraryState::missing);
  EXPECT_NE(missing.reason.find("libthigma_absent.so"), std::string::npos);

  const LibraryProbe loadable = probe_library({"", "", math, floor_only, ""});
  EXPECT_EQ(loadable.state, LibraryState::loadable);
  EXPECT_EQ(loadable.name, "libm.so.6");
  EXPECT_EQ(loadable.reason, "");

  const LibraryProbe incomplete = probe_library({"", "", math, more, ""});
  EXPECT_EQ(incomplete.state, LibraryState::incomplete);
  EXPECT_EQ(incomplete.reason, "lacks the symbol hdBeginFrame");
}

TEST(VendorLibraries, WhatIsThereAndDoesNotOpenIsNotCalledMissing) {
  const std::string file = testing::TempDir() + "libthigma_garbage.so";
  std::ofstream(file) << std::string(4096, 'x');
  const char* const names[] = {file.c_str()};
  const char* const none[] = {"floor"};
  const LibraryProbe probe = probe_library({"", "", names, none, ""});
  EXPECT_EQ(probe.state, LibraryState::unusable);
  EXPECT_NE(probe.reason.find("invalid ELF header"), std::string::npos) << probe.reason;
  EXPECT_NE(probe.fix.find("64-bit"), std::string::npos) << probe.fix;
  std::remove(file.c_str());
}

TEST(VendorLibraries, EveryRowSaysWhatToDo) {
  ASSERT_FALSE(vendor_libraries().empty());
  for (const VendorLibrary& library : vendor_libraries()) {
    EXPECT_FALSE(library.names.empty());
    EXPECT_FALSE(library.symbols.empty());
    EXPECT_EQ(library.scheme.back(), ':');
    EXPECT_EQ(library.fix.back(), '.');
  }
}

}  // namespace
}  // namespace thigma
