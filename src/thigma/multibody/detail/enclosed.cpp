#include "thigma/multibody/detail/enclosed.h"

#include <numeric>

#include "thigma/contact/surface_crossing.h"
#include "thigma/core/index.h"
#include "thigma/multibody/detail/pair_kinds.h"

namespace thigma::detail {
namespace {

// Ways of rays, along no axis and no diagonal of what is drawn or made by rule.
const std::array<Vec3, 3> kWays = {Vec3(0.8116, 0.4731, 0.3425), Vec3(-0.3718, 0.8429, 0.3892),
                                   Vec3(0.2913, -0.4337, 0.8526)};
// How far a probe looks to either side of its triangle, of the other surface's size. Rays see
// nothing nearer than 1e-6 of their length, which is four sizes.
constexpr double kSide = 1e-5, kRay = 4.0;

/// The least vertex of the connected part that each vertex is of.
std::vector<std::int32_t> part_of_vertices(const SurfaceFeatures& features) {
  std::vector<std::int32_t> part(features.vertices.size());
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](std::int32_t v) {
    while (part[idx(v)] != v) v = part[idx(v)] = part[idx(part[idx(v)])];
    return v;
  };
  for (const SurfaceTriangle& t : features.triangles) {
    for (std::size_t k = 1; k < 3; ++k) {
      const std::int32_t a = root(t.vertex[0]), b = root(t.vertex[k]);
      part[idx(std::max(a, b))] = std::min(a, b);
    }
  }
  for (std::size_t v = 0; v < part.size(); ++v) part[v] = root(static_cast<std::int32_t>(v));
  return part;
}

Vec3 middle_of(const SurfaceFeatures& features, const SurfaceTriangle& t) {
  return (features.vertices[idx(t.vertex[0])] + features.vertices[idx(t.vertex[1])] +
          features.vertices[idx(t.vertex[2])]) /
         3.0;
}

/// How often a closed surface goes around a point, by the rays to both sides; nothing where they
/// disagree, as the point lies on it.
std::optional<int> turns_around(const ClodHierarchy& surface, const Vec3& point, const Vec3& way) {
  const int ahead = count_crossings(surface, point, point + way).exits_after_from;
  const int behind = count_crossings(surface, point, point - way).exits_after_from;
  if (ahead != behind) return std::nullopt;
  return ahead;
}

/// Votes of a part's probes.
bool is_part_inside(const std::array<SurfaceProbe, 6>& probes, const Pose& outer_from_inner,
                    const ClodHierarchy& outer) {
  constexpr int kEnough = 3;
  const double side = kSide * outer.radius, length = kRay * outer.radius;
  std::array<SurfaceProbe, 6> placed;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    placed[i] = {transform_point(outer_from_inner, probes[i].point),
                 outer_from_inner.orientation._transformVector(probes[i].normal)};
    if ((placed[i].point - outer.center).norm() > 1.02 * outer.radius) return false;
  }
  int inside = 0, outside = 0;
  for (std::size_t i = 0; i < placed.size() && std::max(inside, outside) < kEnough; ++i) {
    const Vec3 way = length * kWays[i % kWays.size()];
    const auto out = turns_around(outer, placed[i].point + side * placed[i].normal, way);
    if (!out) continue;
    const auto in = turns_around(outer, placed[i].point - side * placed[i].normal, way);
    if (in != out) continue;
    ++(*in > 0 ? inside : outside);
  }
  return inside > outside;
}

}  // namespace

ShapeParts find_parts(const BodyShape& shape, const SurfaceFeatures& features) {
  ShapeParts found;
  found.is_closed = is_closed(*shape.hierarchy);
  const std::vector<std::int32_t> part = part_of_vertices(features);
  std::vector<std::int32_t> place(part.size(), -1);  // by vertex, into found.parts
  std::vector<std::array<double, 6>> best;
  for (const SurfaceTriangle& t : features.triangles) {
    const Vec3 middle = middle_of(features, t);
    std::int32_t& at = place[idx(part[idx(t.vertex[0])])];
    const bool is_new = at < 0;
    if (is_new) {
      at = static_cast<std::int32_t>(found.parts.size());
      found.parts.emplace_back();
      best.emplace_back();
    }
    for (std::size_t k = 0; k < 6; ++k) {
      const double along = (k < 3 ? 1.0 : -1.0) * middle[static_cast<int>(k % 3)];
      if (!is_new && along <= best[idx(at)][k]) continue;
      best[idx(at)][k] = along;
      found.parts[idx(at)][k] = {middle, t.normal};
    }
  }
  return found;
}

const ShapeParts& PartsOfShapes::of(std::int32_t shape) {
  std::optional<ShapeParts>& known = known_[idx(shape)];
  if (known) return *known;
  for (const PairKind& kind : world_.pair_kinds->list) {
    if (kind.first != shape && kind.second != shape) continue;
    const SurfaceFeatures& features =
        kind.first == shape ? kind.constraints.object : *kind.constraints.scene[0];
    return known.emplace(find_parts(world_.shapes[idx(shape)], features));
  }
  return known.emplace();
}

bool is_enclosed(const World& world, const WorldState& state, std::int32_t inner,
                 std::int32_t outer, PartsOfShapes& parts) {
  const std::int32_t inner_shape = world.shape[idx(inner)], outer_shape = world.shape[idx(outer)];
  if (!parts.of(outer_shape).is_closed) return false;
  const auto world_from_mesh = [&](std::int32_t body, std::int32_t shape) {
    const BodyState& y = state.bodies[idx(body)];
    return Pose{y.position, y.orientation} * world.shapes[idx(shape)].body_from_mesh;
  };
  const Pose outer_from_inner =
      inverse(world_from_mesh(outer, outer_shape)) * world_from_mesh(inner, inner_shape);
  for (const auto& probes : parts.of(inner_shape).parts)
    if (is_part_inside(probes, outer_from_inner, *world.shapes[idx(outer_shape)].hierarchy))
      return true;
  return false;
}

}  // namespace thigma::detail
