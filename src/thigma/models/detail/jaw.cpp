// Rings across the arch, each the outline of the ridge there: over the teeth from the tongue's side
// to the cheek's, and back along the base. Within a ring vertices lie as dense as the relief is
// steep, and so do the rings along the arch.
//
// Why it cannot cross itself: rings stand in vertical planes that meet only inside the arch's
// evolute, beyond the ridge; seen from above every band of the top is then a strip of unfolded
// triangles, so the top is a height over the ridge's floor plan, the underside another, and the
// first lies above the second.

#include "thigma/models/detail/jaw.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "thigma/math/elementary.h"
#include "thigma/models/detail/jaw_relief.h"
#include "thigma/models/detail/rings.h"

namespace thigma::models {
namespace {

using Relief = std::function<double(double s, double t)>;

constexpr int kTableRows = 512;    // of the slope table, along the arch
constexpr int kTableColumns = 96;  // and across
constexpr double kSteepest = 6.0;  // slopes above count as this: walls get enough vertices, no more
constexpr double kBaseShare = 0.3;  // density of vertices on the underside against the top

/// How dense vertices should lie: lengths of surface over the floor plan, averaged.
struct Density {
  std::vector<double> along;  // kTableRows: at s = length (i + 0.5) / kTableRows
  // same rows; over u = t / half_width in -1..1, smoothed along the arch
  std::vector<std::vector<double>> across;
};

double stretch(double slope) {
  return std::sqrt(1.0 + std::min(slope * slope, kSteepest * kSteepest));
}

/// Mean of values[i - reach .. i + reach] within bounds.
double window_mean(const std::vector<double>& values, int i, int reach) {
  const int first = std::max(0, i - reach);
  const int last = std::min(static_cast<int>(values.size()) - 1, i + reach);
  double sum = 0.0;
  for (int k = first; k <= last; ++k) sum += values[k];
  return sum / (last - first + 1);
}

Density measure_density(const JawRelief& jaw, const Relief& relief) {
  std::vector<std::vector<double>> z(kTableRows + 1, std::vector<double>(kTableColumns + 1));
  std::vector<double> half(kTableRows + 1);
  for (int i = 0; i <= kTableRows; ++i) {
    const double s = jaw.length * i / kTableRows;
    half[i] = half_width(jaw, s);
    for (int j = 0; j <= kTableColumns; ++j)
      z[i][j] = relief(s, half[i] * (2.0 * j / kTableColumns - 1.0));
  }
  const double ds = jaw.length / kTableRows;
  std::vector<double> along(kTableRows, 0.0);
  std::vector<std::vector<double>> columns(kTableColumns, std::vector<double>(kTableRows));
  for (int i = 0; i < kTableRows; ++i) {
    for (int j = 0; j < kTableColumns; ++j) {
      along[i] += stretch((z[i + 1][j] - z[i][j]) / ds) / kTableColumns;
      columns[j][i] = half[i] * stretch((z[i][j + 1] - z[i][j]) / (2.0 * half[i] / kTableColumns));
    }
  }
  // A window of about a millimetre and a half along the arch keeps the columns of neighbouring
  // rings together.
  Density density;
  const int reach = static_cast<int>(1.5e-3 / ds);
  for (int i = 0; i < kTableRows; ++i) {
    density.along.push_back(window_mean(along, i, 2));
    std::vector<double> row(kTableColumns);
    for (int j = 0; j < kTableColumns; ++j) row[j] = window_mean(columns[j], i, reach);
    density.across.push_back(row);
  }
  return density;
}

/// n + 1 places in 0..1, the first 0, the last 1, as dense as `weights` (of equal bins) say.
std::vector<double> spread(const std::vector<double>& weights, int n) {
  std::vector<double> sums(weights.size() + 1, 0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) sums[i + 1] = sums[i] + weights[i];
  std::vector<double> places = {0.0};
  std::size_t bin = 0;
  for (int k = 1; k < n; ++k) {
    const double wanted = sums.back() * k / n;
    while (bin + 1 < weights.size() && sums[bin + 1] < wanted) ++bin;
    const double within = std::clamp((wanted - sums[bin]) / weights[bin], 0.0, 1.0);
    places.push_back((static_cast<double>(bin) + within) / static_cast<double>(weights.size()));
  }
  places.push_back(1.0);
  return places;
}

/// Underside at u = t / half_width: flat with rounded edges.
double base_height(double u) {
  const double u4 = u * u * u * u;
  return kRidgeEdge +
         (kRidgeBase - kRidgeEdge) * std::sqrt(std::sqrt(std::max(0.0, 1.0 - u4 * u4)));
}

/// Places of the underside's inner vertices, evenly by length, from +1 to -1, both left out.
std::vector<double> base_places(int n) {
  constexpr int kSteps = 512;
  std::vector<double> weights;
  for (int i = 0; i < kSteps; ++i) {
    const double a = 2.0 * i / kSteps - 1.0;
    const double b = 2.0 * (i + 1) / kSteps - 1.0;
    const double dz = (base_height(b) - base_height(a)) / 7.5e-3;
    weights.push_back(std::sqrt((b - a) * (b - a) + dz * dz));
  }
  std::vector<double> places;
  for (const double x : spread(weights, n)) places.push_back(1.0 - 2.0 * x);
  places.erase(places.begin());
  places.pop_back();
  return places;
}

TriangleMesh build_jaw(const DentalArch& arch, const JawRelief& jaw, const Relief& relief,
                       int triangles) {
  const GridCounts counts = nearest_counts(triangles, 2.8, 1, 8, [](int around, int along) {
    return 2ll * around * along + 2ll * disc_triangles(around);
  });
  const Density density = measure_density(jaw, relief);
  const int base_cells = std::max(2, static_cast<int>(counts.around * kBaseShare));
  const int top_cells = counts.around - base_cells;
  const std::vector<double> base = base_places(base_cells);
  TriangleMesh mesh;
  std::vector<Ring> rings;
  for (const double place : spread(density.along, counts.along)) {
    const double s = arch.length * place;
    const ArchFrame frame = arch_frame(arch, s);
    const double half = half_width(jaw, s);
    std::vector<Vec3> outline;
    const auto add = [&](double u, double z) {
      const Vec2 p = frame.point + frame.outward * (u * half);
      outline.emplace_back(p.x(), p.y(), z);
    };
    const int row = std::min(static_cast<int>(place * kTableRows), kTableRows - 1);
    const std::vector<double> top = spread(density.across[row], top_cells);
    for (const double x : top) {
      const bool is_edge = x == 0.0 || x == 1.0;
      add(2.0 * x - 1.0, is_edge ? kRidgeEdge : relief(s, half * (2.0 * x - 1.0)));
    }
    for (const double u : base) add(u, base_height(u));
    rings.push_back(add_ring(mesh, outline));
  }
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    const Ring& low = rings[i + 1];
    const Ring& high = rings[i];
    join_rings(mesh, low, high, [&](int j) {
      const int k = (j + 1) % counts.around;
      const std::vector<Vec3>& p = mesh.positions;
      return (p[low.first + k] - p[high.first + j]).squaredNorm() <
             (p[low.first + j] - p[high.first + k]).squaredNorm();
    });
  }
  for (const bool at_end : {false, true}) {
    const ArchFrame frame = arch_frame(arch, at_end ? arch.length : 0.0);
    const Vec3 centre(frame.point.x(), frame.point.y(), kRidgeEdge);
    close_ring(mesh, at_end ? rings.back() : rings.front(), centre, at_end);
  }
  return mesh;
}

}  // namespace

TriangleMesh make_lower_jaw(int triangles, std::uint64_t seed) {
  const DentalArch arch = make_dental_arch();
  const JawRelief jaw = lower_relief(arch, seed);
  return build_jaw(
      arch, jaw, [&](double s, double t) { return surface_height(jaw, s, t); }, triangles);
}

TriangleMesh make_upper_jaw(int triangles, std::uint64_t seed) {
  const DentalArch arch = make_dental_arch();
  const JawRelief lower = lower_relief(arch, seed);
  const JawRelief upper = upper_relief(arch, seed);
  // Seen from below; where the teeth would bite into the lower jaw they are worn to its shape.
  const auto worn = [&](double s, double t) {
    const double own = surface_height(upper, s, t);
    const double limit = -surface_height(lower, s, t) - occlusal_gap(s, t);
    constexpr double kBlend = 0.2e-3;
    const double h = std::max(kBlend - std::fabs(own - limit), 0.0) / kBlend;
    return std::min(own, limit) - 0.25 * h * h * kBlend;
  };
  TriangleMesh mesh = build_jaw(arch, upper, worn, triangles);
  for (Vec3& p : mesh.positions) p.z() = -p.z();
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace thigma::models
