#include "thigma/core/shared_library.h"

#include <utility>

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(SharedLibrary, OpensTheFirstThatIsThere) {
  const char* const names[] = {"libthigma_does_not_exist.so.9", "libm.so.6"};
  auto library = SharedLibrary::open(names);
  ASSERT_TRUE(library.has_value());
  EXPECT_EQ(library->name(), "libm.so.6");
  const auto floor_of = reinterpret_cast<double (*)(double)>(library->symbol("floor"));
  ASSERT_NE(floor_of, nullptr);
  EXPECT_EQ(floor_of(2.5), 2.0);
  const char* const symbols[] = {"floor", "no_such_symbol", "neither"};
  EXPECT_STREQ(library->first_missing(symbols), "no_such_symbol");
  EXPECT_EQ(library->first_missing(std::span(symbols).first(1)), nullptr);
  SharedLibrary moved = std::move(*library);
  EXPECT_NE(moved.symbol("floor"), nullptr);
}

TEST(SharedLibrary, SaysWhyNothingOpened) {
  const char* const names[] = {"libthigma_a.so", "libthigma_b.so"};
  std::string error;
  EXPECT_FALSE(SharedLibrary::open(names, &error).has_value());
  EXPECT_NE(error.find("libthigma_a.so"), std::string::npos);
  EXPECT_NE(error.find("libthigma_b.so"), std::string::npos);
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace thigma
