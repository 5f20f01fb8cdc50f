#include "thigma/depth/triangle_ring.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

bool touch_each_other(const TriangleMesh& mesh, std::int32_t a, std::int32_t b) {
  const auto& p = mesh.triangles[static_cast<std::size_t>(a)];
  const auto& q = mesh.triangles[static_cast<std::size_t>(b)];
  return std::any_of(p.begin(), p.end(),
                     [&](std::int32_t v) { return std::find(q.begin(), q.end(), v) != q.end(); });
}

TEST(TriangleRing, is_what_touches_and_is_not_of_the_set) {
  const TriangleMesh mesh = make_ball(0.01, 6);
  const VertexTriangles at_vertex = vertex_triangles(mesh);
  const std::int32_t count = static_cast<std::int32_t>(mesh.triangles.size());
  TriangleMarks marks{std::vector<std::uint32_t>(mesh.triangles.size(), 0u)};
  for (std::int32_t first = 0; first + 3 < count; first += 7) {
    const std::vector<std::int32_t> own = {first, first + 1, first + 3};
    marks.begin();
    for (const std::int32_t t : own) EXPECT_TRUE(marks.add(t));
    std::vector<std::int32_t> ring;
    add_ring(mesh, at_vertex, own, marks, ring);
    std::set<std::int32_t> want;
    for (std::int32_t t = 0; t < count; ++t)
      for (const std::int32_t o : own)
        if (std::find(own.begin(), own.end(), t) == own.end() && touch_each_other(mesh, o, t))
          want.insert(t);
    EXPECT_EQ(ring.size(), want.size());
    EXPECT_EQ(std::set<std::int32_t>(ring.begin(), ring.end()), want);
  }
}

TEST(TriangleRing, is_empty_of_no_mesh_and_marks_outlast_their_count) {
  const TriangleMesh mesh = make_box({0.01, 0.01, 0.01});
  const std::vector<std::int32_t> own = {0};
  TriangleMarks marks{std::vector<std::uint32_t>(mesh.triangles.size(), 0u)};
  std::vector<std::int32_t> ring;
  marks.begin();
  marks.add(0);
  add_ring(mesh, {}, own, marks, ring);
  EXPECT_TRUE(ring.empty());
  marks.round = 0xffffffffu;
  marks.of.assign(marks.of.size(), 1u);  // as 2^32 - 1 sets before
  marks.begin();
  EXPECT_TRUE(marks.add(5));
  EXPECT_FALSE(marks.add(5));
}

}  // namespace
}  // namespace thigma
