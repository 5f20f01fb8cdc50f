#include "thigma/import/detail/shell_snap.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "thigma/core/index.h"
#include "thigma/import/nearest_point.h"
#include "thigma/mesh/self_intersections.h"

namespace thigma::detail {
namespace {

// Shares of the way a vertex tries, one after the other. The last is where it began, and there no
// triangles meet.
constexpr std::array<double, 7> kShares{1.0, 0.98, 0.9, 0.75, 0.5, 0.25, 0.0};
constexpr std::uint8_t kLast = kShares.size() - 1;

// A triangle may turn this far from where it began (cosine), and keep at least this share of its
// area: corners that point outwards shrink to the square of the rest over the offset.
constexpr double kLeastCosine = 0.05;
constexpr double kLeastArea = 1e-5;

struct Snap {
  const TriangleMesh& from;        // as it began
  std::vector<Vec3> target;        // of each vertex
  std::vector<std::uint8_t> step;  // of each vertex, into kShares
  TriangleMesh now;

  Vec3 place(std::size_t v) const {
    if (step[v] == kLast) return from.positions[v];
    return from.positions[v] + kShares[step[v]] * (target[v] - from.positions[v]);
  }
};

Vec3 twice_area(const std::vector<Vec3>& x, const std::array<std::int32_t, 3>& t) {
  return (x[idx(t[1])] - x[idx(t[0])]).cross(x[idx(t[2])] - x[idx(t[0])]);
}

bool keeps_shape(const Snap& snap, const std::array<std::int32_t, 3>& t) {
  const Vec3 before = twice_area(snap.from.positions, t), after = twice_area(snap.now.positions, t);
  const double size = after.norm();
  return size >= kLeastArea * before.norm() &&
         after.dot(before) >= kLeastCosine * size * before.norm();
}

void mark(const std::array<std::int32_t, 3>& t, std::vector<std::uint8_t>& is_marked) {
  for (const std::int32_t v : t) is_marked[idx(v)] = 1;
}

// Vertices in the same place would be one to whoever reads the mesh.
void mark_equal(const Snap& snap, std::vector<std::uint8_t>& is_marked) {
  std::vector<std::int32_t> order(snap.now.positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](std::int32_t v) {
    const Vec3& p = snap.now.positions[idx(v)];
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return place(a) < place(b) || (place(a) == place(b) && a < b);
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (place(order[i - 1]) == place(order[i]))
      is_marked[idx(order[i - 1])] = is_marked[idx(order[i])] = 1;
}

// Holds the marked vertices back by one step; false where there is none to take back.
bool hold_back(Snap& snap, const std::vector<std::uint8_t>& is_marked) {
  bool any = false;
  for (std::size_t v = 0; v < is_marked.size(); ++v) {
    if (is_marked[v] == 0 || snap.step[v] == kLast) continue;
    ++snap.step[v];
    snap.now.positions[v] = snap.place(v);
    any = true;
  }
  return any;
}

// Triangles that turned over or collapsed: cheap, so until none is left.
void restore_shapes(Snap& snap) {
  std::vector<std::uint8_t> is_marked;
  do {
    is_marked.assign(snap.now.positions.size(), 0);
    for (const auto& t : snap.now.triangles)
      if (!keeps_shape(snap, t)) mark(t, is_marked);
    mark_equal(snap, is_marked);
  } while (hold_back(snap, is_marked));
}

// Triangles that meet, and their neighbours, so that a fold opens as a whole.
bool part(Snap& snap) {
  const SelfIntersections meeting = find_self_intersections(snap.now, true);
  std::vector<std::uint8_t> is_marked(snap.now.positions.size(), 0);
  for (const auto& pair : meeting.found)
    for (const std::int32_t t : pair) mark(snap.now.triangles[idx(t)], is_marked);
  return hold_back(snap, is_marked);
}

}  // namespace

std::int64_t snap_shell(TriangleMesh& shell, const TriangleMesh& mesh, const TriangleTree& tree,
                        double rest, const std::function<void(double)>& progress) {
  Snap snap{shell, shell.positions, std::vector<std::uint8_t>(shell.positions.size(), 0), shell};
  for (std::size_t v = 0; v < shell.positions.size(); ++v) {
    const NearestPoint n = nearest_point(mesh, tree, shell.positions[v]);
    if (n.distance > rest)
      snap.target[v] = n.point + (rest / n.distance) * (shell.positions[v] - n.point);
    snap.now.positions[v] = snap.place(v);
  }
  int rounds = 0;
  do {
    restore_shapes(snap);
    if (progress) progress(static_cast<double>(rounds) / (rounds + 4.0));
    ++rounds;
  } while (part(snap));
  shell.positions = std::move(snap.now.positions);
  return static_cast<std::int64_t>(snap.step.size()) -
         std::count(snap.step.begin(), snap.step.end(), std::uint8_t{0});
}

}  // namespace thigma::detail
