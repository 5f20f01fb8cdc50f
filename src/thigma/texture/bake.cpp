#include "thigma/texture/bake.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/measure.h"
#include "thigma/texture/charts.h"
#include "thigma/texture/detail/bake_fit.h"
#include "thigma/texture/detail/seams.h"
#include "thigma/texture/detail/surface_search.h"
#include "thigma/texture/detail/texel_owners.h"

namespace thigma {
namespace {

// Texels beyond a chart's edge that interpolation and differences may touch.
constexpr double kMargin = 3.0;

using CornerNormals = std::vector<std::array<Vec3, 3>>;

Vec3 face_normal(const TriangleMesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  const Vec3& a = mesh.positions[idx(v[0])];
  return (mesh.positions[idx(v[1])] - a).cross(mesh.positions[idx(v[2])] - a);
}

/// Normals at the corners: of all faces around the vertex, by area, that turn away from the
/// corner's own by less than an angle of cosine `crease`; -1 for all.
CornerNormals corner_normals(const TriangleMesh& mesh, double crease) {
  std::vector<std::vector<std::int32_t>> around(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::int32_t v : mesh.triangles[t])
      around[idx(v)].push_back(static_cast<std::int32_t>(t));
  CornerNormals normals(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 own = face_normal(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 sum = Vec3::Zero();
      for (const std::int32_t other : around[idx(mesh.triangles[t][k])]) {
        const Vec3 n = face_normal(mesh, idx(other));
        if (n.dot(own) >= crease * n.norm() * own.norm()) sum += n;
      }
      normals[t][k] = sum.norm() > 0.0 ? sum.normalized() : own.normalized();
    }
  }
  return normals;
}

template <class Values>
auto blend(const Values& of_corners, const Vec3& weights) {
  return (weights[0] * of_corners[0] + weights[1] * of_corners[1] + weights[2] * of_corners[2])
      .eval();
}

std::array<Vec3, 3> corners_of(const TriangleMesh& mesh, std::int32_t t) {
  const auto& v = mesh.triangles[idx(t)];
  return {mesh.positions[idx(v[0])], mesh.positions[idx(v[1])], mesh.positions[idx(v[2])]};
}

/// A surface on the way from the fine one to coarser ones.
struct Stage {
  detail::SurfaceSearch search;
  CornerNormals normals;  // of all but the fine one
  double reach = 0.0;     // to the one before, along a normal [m]
};

/// The fine surface as it is seen from the coarsest, through those between them.
struct Sight {
  std::vector<Stage> stages;  // from the fine surface to the coarsest

  const detail::SurfaceSearch& fine() const { return stages.front().search; }
  const detail::SurfaceSearch& coarse() const { return stages.back().search; }

  /// From a point of the coarsest surface to the fine point that belongs to it.
  Vec3 displacement(const detail::SurfacePoint& from) const {
    detail::SurfacePoint on = from;
    for (std::size_t i = stages.size() - 1; i > 0; --i) on = next(i, on);
    return on.at - from.at;
  }

 private:
  detail::SurfacePoint next(std::size_t i, const detail::SurfacePoint& from) const {
    const Stage& stage = stages[i];
    const detail::SurfaceSearch& finer = stages[i - 1].search;
    const Vec3 normal = blend(stage.normals[idx(from.triangle)], from.weights);
    const double length = normal.norm();
    if (length > 0.0) {
      const detail::SurfacePoint hit =
          detail::crossing_point(finer, from.at, normal / length, stage.reach);
      if (hit.triangle >= 0) return hit;
    }
    return detail::nearest_point(finer, from.at);
  }
};

/// Largest distance of some points of a surface to another.
double largest_distance(const TriangleMesh& from, const detail::SurfaceSearch& to) {
  constexpr std::size_t kMost = 20000;
  const std::size_t step = std::max<std::size_t>(1, from.positions.size() / kMost);
  double largest = 0.0;
  for (std::size_t i = 0; i < from.positions.size(); i += step)
    largest = std::max(largest, detail::nearest_point(to, from.positions[i]).distance);
  return largest;
}

double farthest(const detail::SurfaceSearch& one, const detail::SurfaceSearch& other) {
  return std::max(largest_distance(*one.mesh, other), largest_distance(*other.mesh, one));
}

Sight sight_of(const TriangleMesh& fine) {
  Sight sight;
  sight.stages.push_back({detail::build_surface_search(fine), {}, 0.0});
  return sight;
}

/// The surfaces stay where they are as long as the sight does.
void look_from(const TriangleMesh& coarse, Sight& sight) {
  Stage stage{detail::build_surface_search(coarse), corner_normals(coarse, -1.0), 0.0};
  // A line along a normal that leans on the surface is longer than the distance.
  stage.reach = 2.0 * farthest(sight.coarse(), stage.search);
  sight.stages.push_back(std::move(stage));
}

void check_fit(const Sight& sight, const std::string& name) {
  const bool is_direct = sight.stages.size() == 2;
  const double apart =
      is_direct ? 0.5 * sight.stages.back().reach : farthest(sight.fine(), sight.coarse());
  if (!(apart < enclosing_ball(sight.coarse().mesh->positions).radius))
    throw InputError(
        name + ": lies " + std::to_string(apart) +
        " m from the coarse surface, at its farthest vertex, expected one that it fits");
}

Texel texel_of(const Vec3& d) {
  return {static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z())};
}

void fill_texels(const Sight& sight, TextureSource& source) {
  // Texels of a chart are seen; those beyond its edge only by interpolation, and may give way.
  constexpr double kEaseInside = 0.1;
  const detail::TexelOwners owners =
      detail::find_texel_owners(source.corners, source.width, source.height, kMargin);
  const std::size_t count = owners.triangle.size(), width = static_cast<std::size_t>(source.width);
  detail::StitchedMap map{source.width, source.height, std::vector<Vec3>(count, Vec3::Zero()),
                          std::vector<double>(count, 1.0)};
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t t = owners.triangle[i];
    if (t < 0) continue;
    const Vec2 texel(static_cast<double>(i % width), static_cast<double>(i / width));
    const Vec3 weights = detail::corner_weights(source.corners[idx(t)], texel);
    const Vec3 place = blend(corners_of(*sight.coarse().mesh, t), weights);
    const bool is_inside = weights.minCoeff() >= 0.0;
    if (is_inside) map.ease[i] = kEaseInside;
    // Beyond the chart's edge the surface goes on as the neighbour.
    const detail::SurfacePoint on = is_inside ? detail::SurfacePoint{t, weights, place, 0.0}
                                              : detail::nearest_point(sight.coarse(), place);
    map.texels[i] = sight.displacement(on);
  }
  detail::stitch_seams(detail::find_seams(source.coarse, source.corners), source.corners, map);
  source.texels.clear();
  for (const Vec3& d : map.texels) source.texels.push_back(texel_of(d));
}

TextureAsset bake(const Sight& sight, const BakeParams& params, const std::string& name) {
  const TriangleMesh& coarse = *sight.coarse().mesh;
  const ChartMap charts = make_charts(coarse, {.texels = params.texels}, name);
  check_fit(sight, name);
  TextureSource source;
  source.coarse = coarse;
  source.corners = charts.corners;
  source.width = source.height = params.texels;
  fill_texels(sight, source);
  TextureAsset asset;
  asset.texture = make_texture(std::move(source), name);
  asset.figures =
      detail::measure_fit(*sight.fine().mesh, sight.fine(), sight.coarse(), asset.texture,
                          {.samples = params.samples, .seed = params.seed});
  asset.figures.charts = charts.count;
  asset.figures.distortion_max = charts.distortion_max;
  return asset;
}

bool is_same(const TriangleMesh& a, const TriangleMesh& b) {
  return a.triangles == b.triangles && a.positions == b.positions;
}

}  // namespace

TextureAsset bake_surface(const TriangleMesh& fine, const TriangleMesh& coarse,
                          const BakeParams& params, const std::string& name) {
  Sight sight = sight_of(fine);
  look_from(coarse, sight);
  return bake(sight, params, name);
}

std::vector<std::optional<TextureAsset>> bake_levels(const TriangleMesh& fine,
                                                     std::span<const TriangleMesh> levels,
                                                     const BakeParams& params,
                                                     const std::string& name,
                                                     const std::function<void(double)>& progress) {
  std::vector<std::optional<TextureAsset>> textures(levels.size());
  Sight sight = sight_of(fine);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const bool is_fine_itself = k == 0 && is_same(fine, levels[0]);
    if (!is_fine_itself) {
      look_from(levels[k], sight);
      textures[k] = bake(sight, params, name);
    }
    if (progress) progress(static_cast<double>(k + 1) / static_cast<double>(levels.size()));
  }
  return textures;
}

namespace {

/// How much a map stretches or squeezes lengths against its mean, at most.
double distortion(const TextureSource& source) {
  double area = 0.0, in_map = 0.0;
  std::vector<Eigen::Matrix2d> maps;
  for (std::size_t t = 0; t < source.corners.size(); ++t) {
    const std::array<Vec3, 3> p = corners_of(source.coarse, static_cast<std::int32_t>(t));
    const double length = (p[1] - p[0]).norm();
    const Vec3 x = (p[1] - p[0]) / length, c = p[2] - p[0];
    Eigen::Matrix2d from, to;
    from << length, x.dot(c), 0.0, (c - x.dot(c) * x).norm();
    to << source.corners[t][1] - source.corners[t][0], source.corners[t][2] - source.corners[t][0];
    if (!(from.determinant() > 0.0)) continue;
    area += from.determinant();
    in_map += std::fabs(to.determinant());
    maps.push_back(to * from.inverse());
  }
  const double scale = std::sqrt(in_map / area);
  double largest = 1.0;
  for (const Eigen::Matrix2d& map : maps) {
    // Singular values of a 2 x 2 matrix by its squared norm and determinant.
    const double sum = map.squaredNorm(), product = std::fabs(map.determinant());
    const double most =
        std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * product * product))));
    largest = std::max({largest, most / scale, scale * most / product});
  }
  return largest;
}

std::int32_t count_charts(const std::vector<std::array<Vec2, 3>>& corners) {
  // Triangles are of one chart when they share a corner's coordinates.
  std::vector<std::int32_t> root(corners.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](std::int32_t t) {
    while (root[idx(t)] != t) t = root[idx(t)] = root[idx(root[idx(t)])];
    return t;
  };
  std::map<std::array<double, 2>, std::int32_t> first;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (const Vec2& c : corners[t]) {
      const auto [known, is_new] =
          first.emplace(std::array{c.x(), c.y()}, static_cast<std::int32_t>(t));
      if (!is_new) root[idx(find(static_cast<std::int32_t>(t)))] = find(known->second);
    }
  }
  std::int32_t count = 0;
  for (std::size_t t = 0; t < root.size(); ++t) count += root[t] == static_cast<std::int32_t>(t);
  return count;
}

}  // namespace

TextureAsset bake_heights(TriangleMesh coarse, const std::vector<std::array<Vec2, 3>>& coordinates,
                          const HeightImage& image, double amplitude, const std::string& name) {
  if (!(amplitude > 0.0) || !std::isfinite(amplitude))
    throw InputError(name + ": the amplitude is " + std::to_string(amplitude) +
                     ", as given, expected a length above 0");
  TextureSource source;
  source.coarse = std::move(coarse);
  source.width = image.width;
  source.height = image.height;
  for (const std::array<Vec2, 3>& triangle : coordinates) {
    std::array<Vec2, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = Vec2(triangle[k].x() * image.width, (1.0 - triangle[k].y()) * image.height) -
                   Vec2(0.5, 0.5);
    source.corners.push_back(corners);
  }
  source.texels.assign(image.values.size(), Texel{});
  // Refuses what has no place in the map before normals are put there.
  make_texture(source, name);
  constexpr double kCrease = 0.766;  // cosine of 40 degrees
  const CornerNormals normals = corner_normals(source.coarse, kCrease);
  const detail::TexelOwners owners =
      detail::find_texel_owners(source.corners, source.width, source.height, kMargin);
  for (std::size_t i = 0; i < source.texels.size(); ++i) {
    const std::int32_t t = owners.triangle[i];
    if (t < 0) continue;
    const std::size_t width = static_cast<std::size_t>(source.width);
    const Vec2 texel(static_cast<double>(i % width), static_cast<double>(i / width));
    const Vec3 weights =
        detail::corner_weights(source.corners[idx(t)], texel).cwiseMax(0.0).cwiseMin(1.0);
    const Vec3 normal = blend(normals[idx(t)], weights);
    const double height = amplitude * (2.0 * static_cast<double>(image.values[i]) - 1.0);
    if (normal.norm() > 0.0) source.texels[i] = texel_of(height * normal.normalized());
  }
  TextureAsset asset;
  asset.figures.distortion_max = distortion(source);
  asset.figures.charts = count_charts(source.corners);
  asset.texture = make_texture(std::move(source), name);
  return asset;
}

}  // namespace thigma
