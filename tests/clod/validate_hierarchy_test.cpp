#include "thigma/clod/validate_hierarchy.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "clod/asset_samples.h"
#include <gtest/gtest.h>

#include "thigma/clod/detail/build_levels.h"

namespace thigma {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ValidateHierarchy, FindsNothingInWhatIsBuilt) {
  EXPECT_EQ(find_flaw(test::sample_asset().hierarchy), "");
  EXPECT_EQ(find_flaw(build_exact_hierarchy(test::sample_mesh())), "");
  EXPECT_EQ(find_flaw(build_exact_hierarchy(make_box({1, 2, 3}))), "");
  for (const double scale : {1e-9, 1.0, 1e9}) {
    TriangleMesh mesh = make_torus(scale, 0.4 * scale, 20, 12);
    for (Vec3& p : mesh.positions) p += Vec3(1e4, -1e5, 1e3) * scale;
    EXPECT_EQ(find_flaw(build_clod(mesh, test::generous())), "") << scale;
  }
  const detail::TreeForm of_the_text{.is_reparented = false, .has_culling_hulls = false};
  EXPECT_EQ(
      find_flaw(detail::build_levels(test::sample_mesh(), test::generous(), of_the_text, nullptr)),
      "");
}

/// One lie, and the word its message has to hold.
struct Lie {
  const char* says;
  std::function<void(ClodHierarchy&)> tell;
};

/// A patch with room for vertices it does not have.
const ClodPatch& small_patch(const ClodHierarchy& h) {
  const auto vertices = [&](const ClodPatch& p) {
    return p.edge_count > 0 ? h.nodes[static_cast<std::size_t>(p.node)].vertex_count : 99;
  };
  return *std::min_element(
      h.patches.begin(), h.patches.end(),
      [&](const ClodPatch& a, const ClodPatch& b) { return vertices(a) < vertices(b); });
}
std::size_t first_face(const ClodHierarchy& h) {
  return static_cast<std::size_t>(small_patch(h).first_face);
}
std::size_t first_edge(const ClodHierarchy& h) {
  return static_cast<std::size_t>(small_patch(h).first_edge);
}

std::vector<Lie> lies() {
  using H = ClodHierarchy;
  return {
      {"root", [](H& h) { h.nodes.clear(); }},
      {"radius", [](H& h) { h.radius = 0.0; }},
      {"finite", [](H& h) { h.center.y() = kNan; }},
      {"finite", [](H& h) { h.nodes[2].radius = kNan; }},
      {"finite", [](H& h) { h.vertices[5].x() = kNan; }},
      {"finite", [](H& h) { h.support[5][1] = kNan; }},
      {"finite", [](H& h) { h.faces[5].offset = kNan; }},
      {"finite", [](H& h) { h.levels[1].deviation_max = std::numeric_limits<double>::infinity(); }},
      {"children", [](H& h) { h.nodes[0].first_child = 0; }},
      {"children", [](H& h) { h.nodes[0].child_count = 1 << 30; }},
      {"children", [](H& h) { h.nodes[0].child_count = -1; }},
      {"children", [](H& h) { h.nodes[0].first_child = std::numeric_limits<std::int32_t>::max(); }},
      {"two parents", [](H& h) { ++h.nodes[1].child_count; }},
      {"without a parent", [](H& h) { --h.nodes[0].child_count; }},
      {"level", [](H& h) { h.nodes[0].level = 99; }},
      {"level", [](H& h) { h.nodes[1].level = h.nodes[0].level; }},
      {"patch", [](H& h) { h.nodes.back().patch = -1; }},
      {"patch", [](H& h) { h.patches[0].node = 0; }},
      {"contact patch", [](H& h) { h.level_patches[0].patch.node = 1 << 28; }},
      {"level", [](H& h) { h.level_patches[3].level = 0; }},
      {"vertices", [](H& h) { h.nodes[7].vertex_count = 33; }},
      {"vertices", [](H& h) { h.nodes[7].first_vertex = 1 << 30; }},
      {"vertices", [](H& h) { h.level_patches[2].vertex_count = 0; }},
      {"lanes", [](H& h) { h.nodes[7].first_lane += 4; }},
      {"lanes", [](H& h) { h.lanes.resize(h.lanes.size() - 8); }},
      {"lanes", [](H& h) { h.lanes[77] += 1.0f; }},
      {"sphere", [](H& h) { h.nodes[7].radius *= 0.99; }},
      {"faces", [](H& h) { h.patches[1].face_count = 1 << 29; }},
      {"edges", [](H& h) { h.patches[1].first_edge = -5; }},
      {"triangles", [](H& h) { h.patches[1].triangle_count = 0; }},
      {"triangle", [](H& h) { h.hull_triangles[9].corner[1] = 40; }},
      {"triangle", [](H& h) { h.hull_triangles[9].mask = 0; }},
      {"triangle", [](H& h) { h.triangle_ids[9] = -2; }},
      {"triangle", [](H& h) { h.triangle_ids.back() = 1 << 30; }},
      {"face", [](H& h) { h.faces[first_face(h)].vertices = 1u << 31; }},
      {"face", [](H& h) { h.faces[9].normal *= 2.0; }},
      {"edge", [](H& h) { h.edges[first_edge(h)].head = 31; }},
      {"edge", [](H& h) { h.edges[4].face_left = 3000; }},
      {"edge", [](H& h) { h.edges[4].face_right = -2; }},
      {"resolution", [](H& h) { h.levels[1].resolution = 0.0; }},
      {"count", [](H& h) { ++h.levels[1].node_count; }},
      {"count", [](H& h) { ++h.levels[1].patch_count; }},
      {"order", [](H& h) { h.levels[0].is_free = true; }},
      {"level", [](H& h) { h.levels.back().is_free = false; }},
      {"bounds", [](H& h) { h.vertex_to_below.clear(); }},
      {"bounds", [](H& h) { h.vertex_to_below[4] = -1.0f; }},
      {"bounds", [](H& h) { h.triangle_to_below[4] = static_cast<float>(kNan); }},
      {"negative", [](H& h) { h.level_patches[4].to_below = -1.0; }},
      {"support", [](H& h) { h.support.pop_back(); }},
  };
}

TEST(ValidateHierarchy, NamesEveryLie) {
  int i = 0;
  for (const Lie& lie : lies()) {
    ClodHierarchy h = test::sample_asset().hierarchy;
    lie.tell(h);
    const std::string flaw = find_flaw(h);
    EXPECT_NE(flaw.find(lie.says), std::string::npos) << "lie " << i << ": '" << flaw << "'";
    EXPECT_NE(flaw.find(", expected "), std::string::npos) << flaw;
    ++i;
  }
}

}  // namespace
}  // namespace thigma
