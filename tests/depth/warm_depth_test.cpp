// Depth, gradient and force allocate nothing once warm.
#include "depth/textured_plates.h"
#include "reference/texture_force.h"
#include "support/audit.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

/// Slides a contact by small steps, all backends and gradients; returns how many depths were of
/// sheets.
int slide(test::PlateContact& p, std::span<const std::unique_ptr<DepthBackend>> backends,
          GradientScratch& scratch, Vec3& sum) {
  const Pose start = p.contact.object.world_from_body;
  int of_sheets = 0;
  for (int i = 0; i < 20; ++i) {
    p.contact.object.world_from_body.position += 1e-5 * p.contact.normal.unitOrthogonal();
    for (const auto& backend : backends) {
      for (const GradientKind kind : {GradientKind::central_differences, GradientKind::envelope,
                                      GradientKind::smoothed_envelope}) {
        DepthSamples sample;
        backend->sample({&p.contact, 1}, depth_request(kind, 1e-4), {&sample, 1});
        const DepthGradient gradient = depth_gradient(p.contact, sample, kind, scratch);
        sum += texture_wrench(sample.depth[0], gradient, 1000.0).force;
        of_sheets += sample.is_of_sheets;
      }
    }
  }
  p.contact.object.world_from_body = start;
  return of_sheets;
}

TEST(WarmDepth, allocates_nothing) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  Random random(1);
  test::PlateContact smooth(random, {.cells = 3, .texels = 128}),
      folded(random, {.size = 0.005, .cells = 3, .texels = 32, .noise = 2e-4});
  const std::unique_ptr<DepthBackend> backends[] = {
      make_grid_depth({}), make_grid_depth({.is_polished = false}), make_branch_depth({})};
  GradientScratch scratch;
  Vec3 sum = Vec3::Zero();
  slide(smooth, backends, scratch, sum);
  slide(folded, backends, scratch, sum);
  const test::AuditScope watched;
  slide(smooth, backends, scratch, sum);
  const int of_sheets = slide(folded, backends, scratch, sum);
  const test::AuditCounts counts = watched.counts();
  EXPECT_EQ(counts.total(), 0);
  EXPECT_GT(of_sheets, 0);
  EXPECT_GT(sum.norm(), 0.0);
}

}  // namespace
}  // namespace thigma
