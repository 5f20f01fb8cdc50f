#include "thigma/texture/detail/bake_fit.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/random.h"
#include "thigma/texture/detail/seams.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma::detail {
namespace {

std::array<Vec3, 3> corners_of(const TriangleMesh& mesh, std::int32_t t) {
  const auto& v = mesh.triangles[idx(t)];
  return {mesh.positions[idx(v[0])], mesh.positions[idx(v[1])], mesh.positions[idx(v[2])]};
}

/// Calls visit(triangle, weights) for points spread evenly over a surface: by area, one in each of
/// as many equal shares.
template <class Visit>
void visit_samples(const TriangleMesh& mesh, int count, Random& random, const Visit& visit) {
  double total = 0.0;
  const auto area = [&](std::size_t t) {
    const std::array<Vec3, 3> p = corners_of(mesh, static_cast<std::int32_t>(t));
    return (p[1] - p[0]).cross(p[2] - p[0]).norm();
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) total += area(t);
  const double share = total / count;
  double next = share * random.uniform(), passed = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    passed += area(t);
    for (; next < passed; next += share) {
      double b = random.uniform(), c = random.uniform();
      if (b + c > 1.0) {
        b = 1.0 - b;
        c = 1.0 - c;
      }
      visit(static_cast<std::int32_t>(t), Vec3(1.0 - b - c, b, c));
    }
  }
}

Vec3 blend(const std::array<Vec3, 3>& p, const Vec3& w) {
  return w[0] * p[0] + w[1] * p[1] + w[2] * p[2];
}

/// The textured surface in small facets, to find where on it to begin.
struct Facets {
  TriangleMesh mesh;
  std::vector<Vec3> weights;           // of each vertex, on its coarse triangle
  std::vector<std::int32_t> triangle;  // coarse one of each facet
};

/// Sides of facets are about two texels long.
Facets cut_into_facets(const HapticTexture& texture) {
  constexpr double kSide = 2.0;
  constexpr int kMost = 128;  // along a side of a triangle
  Facets facets;
  for (std::size_t t = 0; t < texture.corners.size(); ++t) {
    const std::array<Vec2, 3>& c = texture.corners[t];
    const double longest =
        std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
    const int n = std::clamp(static_cast<int>(std::ceil(longest / kSide)), 1, kMost);
    const auto first = static_cast<std::int32_t>(facets.mesh.positions.size());
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= i; ++j) {
        const Vec3 weights = Vec3(n - i, i - j, j) / n;
        facets.weights.push_back(weights);
        facets.mesh.positions.push_back(
            textured_point(texture, static_cast<std::int32_t>(t), weights));
      }
    }
    const auto vertex = [&](int i, int j) { return first + i * (i + 1) / 2 + j; };
    const auto add = [&](std::int32_t u, std::int32_t v, std::int32_t w) {
      facets.mesh.triangles.push_back({u, v, w});
      facets.triangle.push_back(static_cast<std::int32_t>(t));
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j) {
        add(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        if (j < i) add(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  }
  return facets;
}

/// The coarse point that the facet nearest to p belongs to.
SurfacePoint base_of(const HapticTexture& texture, const Facets& facets,
                     const SurfaceSearch& on_facets, const Vec3& p) {
  const SurfacePoint near = nearest_point(on_facets, p);
  SurfacePoint base;
  base.triangle = facets.triangle[idx(near.triangle)];
  for (int k = 0; k < 3; ++k)
    base.weights +=
        near.weights[k] *
        facets.weights[idx(facets.mesh.triangles[idx(near.triangle)][static_cast<std::size_t>(k)])];
  base.at = blend(corners_of(texture.coarse, base.triangle), base.weights);
  return base;
}

/// From a fine point to the textured surface, at most: what a coarse point must be displaced from
/// is where the fine point lies less the displacement there, found by going there again and again.
double distance_to_textured(const HapticTexture& texture, const SurfaceSearch& on_coarse,
                            SurfacePoint base, const Vec3& p) {
  constexpr int kSteps = 12;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 fine = textured_point(texture, base.triangle, base.weights);
    const double distance = (p - fine).norm();
    if (!(distance < least) && i > 2) break;
    least = std::min(least, distance);
    base = nearest_point(on_coarse, base.at + (p - fine));
  }
  return least;
}

struct Errors {
  double sum = 0.0, largest = 0.0;
  std::int64_t count = 0;
  void add(double error) {
    sum += error * error;
    largest = std::max(largest, error);
    ++count;
  }
};

double largest_crack(const HapticTexture& texture) {
  const std::vector<Seam> seams = find_seams(texture.coarse, texture.corners);
  if (seams.empty()) return 0.0;
  constexpr int kSamples = 10000;
  const int each = kSamples / static_cast<int>(std::min<std::size_t>(seams.size(), kSamples)) + 1;
  double largest = 0.0;
  for (const Seam& seam : seams) {
    for (int i = 0; i < each; ++i) {
      const auto point = [&](const Seam::Side& side) {
        return textured_point(texture, side.triangle, seam_weights(side, (i + 0.5) / each));
      };
      largest = std::max(largest, (point(seam.sides[0]) - point(seam.sides[1])).norm());
    }
  }
  return largest;
}

}  // namespace

Vec3 textured_point(const HapticTexture& texture, std::int32_t triangle, const Vec3& weights) {
  const std::array<Vec2, 3>& c = texture.corners[idx(triangle)];
  const Vec2 texel = weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2];
  return blend(corners_of(texture.coarse, triangle), weights) + displacement_at(texture, texel);
}

BakeFigures measure_fit(const TriangleMesh& fine, const SurfaceSearch& on_fine,
                        const SurfaceSearch& on_coarse, const HapticTexture& texture,
                        const FitParams& params) {
  Random random(params.seed);
  Errors errors;
  visit_samples(texture.coarse, params.samples, random, [&](std::int32_t t, const Vec3& weights) {
    errors.add(nearest_point(on_fine, textured_point(texture, t, weights)).distance);
  });
  const Facets facets = cut_into_facets(texture);
  const SurfaceSearch on_facets = build_surface_search(facets.mesh);
  visit_samples(fine, params.samples, random, [&](std::int32_t t, const Vec3& weights) {
    const Vec3 p = blend(corners_of(fine, t), weights);
    errors.add(std::min(
        distance_to_textured(texture, on_coarse, base_of(texture, facets, on_facets, p), p),
        distance_to_textured(texture, on_coarse, nearest_point(on_coarse, p), p)));
  });
  BakeFigures figures;
  figures.fit_error_rms = std::sqrt(errors.sum / static_cast<double>(errors.count));
  figures.fit_error_max = errors.largest;
  figures.crack_max = largest_crack(texture);
  return figures;
}

}  // namespace thigma::detail
