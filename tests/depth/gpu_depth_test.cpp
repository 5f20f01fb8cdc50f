// Skipped by name where no renderer offers OpenGL 4.3 without a window.
#include "thigma/depth/gpu_depth.h"

#include <iostream>
#include <thread>

#include "depth/textured_plates.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/depth/depth_gradient.h"
#include "thigma/depth/detail/gpu_backend.h"

namespace thigma {
namespace {

// Frames of a loaded machine whose renderer is the processor itself.
constexpr double kPatience = 60.0;  // [s]

class OnGpu : public testing::Test {
 protected:
  void SetUp() override {
    made_ = make_gpu_depth({.grid = {.is_polished = false}, .timeout = kPatience});
    if (!made_.is_on_gpu) GTEST_SKIP() << made_.reason;
    std::cout << "renderer: " << made_.renderer << (made_.is_software ? " (software)" : "") << "\n";
  }
  GpuDepth made_;
};

// Random contacts, several a frame and of different textures, against the scalar reference.
TEST_F(OnGpu, agrees_with_the_scalar_reference) {
  Random random(2);
  const auto scalar = make_grid_depth({.width = SpanWidth::scalar, .is_polished = false});
  const int frames = test::is_full() ? 1250 : 12;
  int found = 0, equal = 0, depths = 0;
  double worst = 0.0;
  std::vector<std::unique_ptr<test::PlateContact>> plates;  // they stay while the backend is used
  const auto make = [&](const test::PlateShape& shape) -> test::PlateContact& {
    plates.push_back(std::make_unique<test::PlateContact>(random, shape));
    return *plates.back();
  };
  for (int i = 0; i < frames; ++i) {
    const test::PlateShape shape{.cells = 1 + i % 5, .bend = 2.0, .noise = 5e-5};
    test::PlateContact &p = make(shape), &q = make({.texels = 40, .amplitude = 1e-4});
    std::vector<DepthContact> contacts;
    const std::vector<std::int32_t> of_p = test::all_triangles(p.object),
                                    of_q = test::all_triangles(q.object);
    const auto add = [&](test::PlateContact& pair, const std::vector<std::int32_t>& triangles) {
      test::shuffle_contact(random, pair, 0.02);
      contacts.push_back(pair.contact);
      contacts.back().object.triangles = contacts.back().scene.triangles = triangles;
    };
    for (int k = 0; k < 4; ++k) {
      add(p, of_p);
      add(q, of_q);
    }
    const DepthRequest request{.has_differences = i % 2 == 0, .near = i % 3 ? 1e-4 : 0.0};
    std::vector<DepthSamples> got(contacts.size()), want(contacts.size());
    made_.backend->sample(contacts, request, got);
    scalar->sample(contacts, request, want);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      ASSERT_EQ(got[c].is_found, want[c].is_found);
      EXPECT_EQ(got[c].is_height_field, want[c].is_height_field);
      EXPECT_EQ(got[c].near.size(), want[c].near.size());
      found += got[c].is_found;
      const double relief =
          contacts[c].object.texture->amplitude + contacts[c].scene.texture->amplitude;
      for (std::size_t k = 0; k < kConfigurations; ++k) {
        ASSERT_EQ(got[c].depth[k] == kNoDepth, want[c].depth[k] == kNoDepth) << k;
        if (got[c].depth[k] == kNoDepth) continue;
        const double off = std::fabs(got[c].depth[k] - want[c].depth[k]) / relief;
        EXPECT_LE(off, kGpuPrecision) << k;
        worst = std::max(worst, off);
        equal += off == 0.0;
        ++depths;
      }
    }
  }
  EXPECT_GT(found, 7 * frames);
  std::cout << found << " contacts, " << depths << " depths, " << equal
            << " of them equal, worst off by " << worst << " of the amplitude\n";
}

TEST_F(OnGpu, grids_wider_than_a_group_and_gradients_agree) {
  Random random(3);
  const GridDepthParams grid{.resolution = 70};
  const GpuDepth wide = make_gpu_depth({.grid = grid, .timeout = kPatience});
  ASSERT_TRUE(wide.is_on_gpu) << wide.reason;
  const auto processor = make_grid_depth(grid);
  GradientScratch scratch;
  const test::PlateShape shape{.cells = 6, .texels = 256, .bend = 2.0};
  const test::PlateContact plates[] = {{random, shape}, {random, shape}};
  for (const test::PlateContact& p : plates) {
    for (const GradientKind kind :
         {GradientKind::central_differences, GradientKind::smoothed_envelope}) {
      const DepthRequest request = depth_request(kind, 6e-4);
      const DepthSamples got = test::depth_of(*wide.backend, p.contact, request),
                         want = test::depth_of(*processor, p.contact, request);
      ASSERT_TRUE(got.is_found && want.is_found);
      EXPECT_NEAR(got.depth[0], want.depth[0], 6e-4 * kGpuPrecision);
      const DepthGradient a = depth_gradient(p.contact, got, kind, scratch),
                          b = depth_gradient(p.contact, want, kind, scratch);
      EXPECT_EQ(a.is_valid, b.is_valid);
      EXPECT_LT((a.linear - b.linear).norm(), 1e-3);
    }
  }
}

TEST_F(OnGpu, contacts_without_depth_and_other_threads_are_fine) {
  Random random(5);
  test::PlateContact p(random, {});
  made_.backend->sample({}, {}, {});
  DepthContact apart = p.contact;
  apart.object.world_from_body.position += 10.0 * p.contact.normal.unitOrthogonal();
  DepthContact broken = p.contact;
  broken.point.x() = std::numeric_limits<double>::quiet_NaN();
  const DepthContact contacts[] = {apart, p.contact, broken};
  DepthSamples here[3], there[3];
  made_.backend->sample(contacts, {}, here);
  EXPECT_FALSE(here[0].is_found);
  EXPECT_TRUE(here[1].is_found);
  EXPECT_FALSE(here[2].is_found);
  std::thread([&] { made_.backend->sample(contacts, {}, there); }).join();
  EXPECT_EQ(here[1].depth, there[1].depth);
}

// What a driver may do in the middle: each time the frame comes from the processor, and one
// warning.
class LostGpu : public testing::TestWithParam<void (*)(detail::GlApi&)> {};

TEST_P(LostGpu, is_given_up_with_one_warning_and_the_right_depth) {
  std::string why;
  auto context = detail::GlContext::open(true, true, why);
  if (!context) GTEST_SKIP() << why;
  auto maps = detail::GpuMaps::open(std::move(context), kPatience, why);
  if (!maps) GTEST_SKIP() << why;
  detail::GlApi& gl = maps->context().api;
  int warnings = 0;
  GpuDepthParams params;
  params.warn = [&](const std::string& text) {
    ++warnings;
    std::cout << text << "\n";
  };
  const auto backend = detail::make_gpu_backend(std::move(maps), params);
  const auto processor = make_grid_depth({});
  Random random(6);
  const test::PlateContact p(random, {});
  const DepthRequest request{.has_differences = true, .near = 1e-4};
  const DepthSamples want = test::depth_of(*processor, p.contact, request);
  EXPECT_NEAR(test::depth_of(*backend, p.contact, request).depth[0], want.depth[0], 1e-8);
  EXPECT_EQ(warnings, 0);
  GetParam()(gl);
  for (int i = 0; i < 3; ++i) {
    const DepthSamples got = test::depth_of(*backend, p.contact, request);
    EXPECT_EQ(got.depth, want.depth);
    EXPECT_EQ(got.near.size(), want.near.size());
    EXPECT_EQ(warnings, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(
    gpu, LostGpu,
    testing::Values(
        +[](detail::GlApi& gl) { gl.get_error = +[]() -> detail::GlEnum { return 0x0505; }; },
        +[](detail::GlApi& gl) { gl.reset_status = +[]() -> detail::GlEnum { return 0x8253; }; },
        +[](detail::GlApi& gl) {
          gl.wait_fence = +[](detail::GlSync, std::uint32_t, std::uint64_t) -> detail::GlEnum {
            return 0x911B;
          };
        },
        +[](detail::GlApi& gl) {
          gl.dispatch = +[](std::uint32_t, std::uint32_t, std::uint32_t) {};
        },
        // Numbers that are no depths: every buffer that comes back is full of them, but for the
        // number of the frame.
        +[](detail::GlApi& gl) {
          static void (*read)(detail::GlEnum, std::ptrdiff_t, std::ptrdiff_t, void*);
          read = gl.read_buffer;
          gl.read_buffer =
              +[](detail::GlEnum target, std::ptrdiff_t first, std::ptrdiff_t bytes, void* data) {
                read(target, first, bytes, data);
                static_cast<float*>(data)[0] += 1.0f;
              };
        }));

TEST(NoGpu, is_told_once_and_the_processor_computes) {
  int warnings = 0;
  const GpuDepth none = make_gpu_depth({.allows_hardware = false,
                                        .allows_software = false,
                                        .warn = [&](const std::string&) { ++warnings; }});
  EXPECT_FALSE(none.is_on_gpu);
  EXPECT_FALSE(none.reason.empty());
  EXPECT_EQ(warnings, 1);
  Random random(7);
  const test::PlateContact p(random, {});
  EXPECT_EQ(test::depth_of(*none.backend, p.contact).depth,
            test::depth_of(*make_grid_depth({}), p.contact).depth);
}

}  // namespace
}  // namespace thigma
