#include "reference/refinement.h"

#include <gtest/gtest.h>

#include "thigma/math/infinity.h"

namespace thigma {
namespace {

TEST(Refinement, the_threshold_itself_is_fine_enough) {
  EXPECT_TRUE(needs_refinement(kInfinity, 0.025));
  EXPECT_FALSE(needs_refinement(0.025, 0.025));
}

TEST(Refinement, tolerances_add) { EXPECT_DOUBLE_EQ(pair_tolerance(1e-3, 2e-4, 3e-4), 1.5e-3); }

}  // namespace
}  // namespace thigma
