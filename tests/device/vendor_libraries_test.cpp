#include "thigma/device/vendor_libraries.h"

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
