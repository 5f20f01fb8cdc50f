#include "thigma/core/parallel.h"

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(ForEachPiece, TakesEveryPieceOnce) {
  for (const int threads : {0, 1, 2, 7})
    for (const std::size_t count : {0u, 1u, 5u, 1000u}) {
      std::vector<int> taken(count, 0);
      for_each_piece(count, threads, [&](std::size_t i) { ++taken[i]; });
      EXPECT_EQ(taken, std::vector<int>(count, 1)) << threads;
    }
}

}  // namespace
}  // namespace thigma
