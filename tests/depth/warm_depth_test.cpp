// Depth, gradient and force allocate nothing once warm.
#include "depth/textured_plates.h"
#include "reference/texture_force.h"
#include "support/audit.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(WarmDepth, allocates_nothing) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  Random random(1);
  test::PlateContact p(random, {.cells = 3, .texels = 128});
  const Pose start = p.contact.object.world_from_body;
  const std::unique_ptr<DepthBackend> backends[] = {
      make_grid_depth({}), make_grid_depth({.is_polished = false}), make_branch_depth({})};
  GradientScratch scratch;
  Vec3 sum = Vec3::Zero();
  const auto slide = [&] {
    p.contact.object.world_from_body = start;
    for (int i = 0; i < 20; ++i) {
      p.contact.object.world_from_body.position += 1e-5 * p.contact.normal.unitOrthogonal();
      for (const auto& backend : backends) {
        for (const GradientKind kind : {GradientKind::central_differences, GradientKind::envelope,
                                        GradientKind::smoothed_envelope}) {
          DepthSamples sample;
          backend->sample({&p.contact, 1}, depth_request(kind, 1e-4), {&sample, 1});
          const DepthGradient gradient = depth_gradient(p.contact, sample, kind, scratch);
          sum += texture_wrench(sample.depth[0], gradient, 1000.0).force;
        }
      }
    }
  };
  slide();
  const test::AuditScope watched;
  slide();
  const test::AuditCounts counts = watched.counts();
  EXPECT_EQ(counts.total(), 0);
  EXPECT_GT(sum.norm(), 0.0);
}

}  // namespace
}  // namespace thigma
