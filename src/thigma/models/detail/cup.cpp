// A turned wall of rings with two rectangular windows, and a tube from the rim of one window to
// that of the other: its section turns from the rectangle into an ellipse on the way.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "thigma/math/elementary.h"
#include "thigma/models/detail/rings.h"
#include "thigma/models/detail/tableware.h"

namespace thigma::models {
namespace {

constexpr double kHeight = 0.110;
constexpr double kFootRadius = 0.044;  // outer, at z = 0
constexpr double kRimRadius = 0.052;   // outer, at the rim
constexpr double kWall = 0.0040;
constexpr double kFloor = 0.0060;
constexpr double kLowJoint = 0.028;  // heights where the handle meets the wall
constexpr double kHighJoint = 0.086;
constexpr double kHandleReach = 0.039;  // of its centre line from the wall
constexpr double kHandleHalfWidth = 0.0075;
constexpr double kHandleHalfThickness = 0.0050;
constexpr double kBlendLength = 0.010;  // of the handle's ends, from rectangle to ellipse

double outer_radius(double z) { return kFootRadius + (kRimRadius - kFootRadius) * z / kHeight; }

/// Everything that follows from the two counts.
struct CupPlan {
  int around = 0;
  int wall_rows = 0, lip_rows = 0, inner_rows = 0;
  int window_columns = 0, window_rows = 0, handle_rows = 0;
};

CupPlan plan_cup(int around, int along) {
  const double edge = 2.0 * kPi * 0.5 * (kFootRadius + kRimRadius) / around;
  CupPlan plan;
  plan.around = around;
  plan.lip_rows = std::max(2, static_cast<int>(0.5 * kPi * kWall / edge + 0.5));
  plan.wall_rows = std::max(2, (along - plan.lip_rows + 1) / 2);
  plan.inner_rows = std::max(1, along - plan.lip_rows - plan.wall_rows);
  plan.window_columns = std::max(2, static_cast<int>(2.0 * kHandleHalfWidth / edge + 0.5));
  plan.window_rows = std::max(2, static_cast<int>(2.0 * kHandleHalfThickness / edge + 0.5));
  plan.handle_rows = std::max(12, static_cast<int>(0.135 / edge + 0.5));
  return plan;
}

long long count_triangles(const CupPlan& plan) {
  const long long rows = plan.wall_rows + plan.lip_rows + plan.inner_rows;
  const long long windows = 2ll * 2ll * plan.window_columns * plan.window_rows;
  const long long handle = 2ll * 2ll * (plan.window_columns + plan.window_rows) * plan.handle_rows;
  return 2ll * plan.around * rows + 2ll * disc_triangles(plan.around) - windows + handle;
}

/// Radius and height of every ring: up the outside, over the lip, down the inside.
std::vector<Vec2> wall_profile(const CupPlan& plan) {
  std::vector<Vec2> profile;
  const double lip = 0.5 * kWall;
  const double shoulder = kHeight - lip;
  for (int k = 0; k <= plan.wall_rows; ++k) {
    const double z = shoulder * k / plan.wall_rows;
    profile.emplace_back(outer_radius(z), z);
  }
  const double middle = outer_radius(shoulder) - lip;
  for (int k = 1; k < plan.lip_rows; ++k) {
    const SinCos a = sin_cos(kPi * k / plan.lip_rows);
    profile.emplace_back(middle + lip * a.cos, shoulder + lip * a.sin);
  }
  for (int k = 0; k <= plan.inner_rows; ++k) {
    const double z = shoulder + (kFloor - shoulder) * k / plan.inner_rows;
    profile.emplace_back(outer_radius(z) - kWall, z);
  }
  return profile;
}

/// Columns 0..window_columns and rows first..first + window_rows of the wall.
struct Window {
  int first_row = 0;
};

/// The window's rim, its corner with the least y and z first, counter-clockwise seen from outside.
std::vector<std::int32_t> window_rim(const std::vector<Ring>& rings, const CupPlan& plan,
                                     const Window& window) {
  std::vector<std::int32_t> rim;
  const int p = plan.window_columns;
  const int q = plan.window_rows;
  const auto vertex = [&](int column, int row) {
    return rings[window.first_row + row].first + column;
  };
  for (int i = 0; i < p; ++i) rim.push_back(vertex(i, 0));
  for (int i = 0; i < q; ++i) rim.push_back(vertex(p, i));
  for (int i = p; i > 0; --i) rim.push_back(vertex(i, q));
  for (int i = q; i > 0; --i) rim.push_back(vertex(0, i));
  return rim;
}

/// The same loop as seen from the tube that arrives from below and outside: starts at the upper
/// left corner.
std::vector<std::int32_t> arriving_rim(const std::vector<Ring>& rings, const CupPlan& plan,
                                       const Window& window) {
  const std::vector<std::int32_t> rim = window_rim(rings, plan, window);
  const int n = static_cast<int>(rim.size());
  const int start = 2 * plan.window_columns + plan.window_rows;
  std::vector<std::int32_t> turned;
  for (int i = 0; i < n; ++i) turned.push_back(rim[(start - i + n) % n]);
  return turned;
}

/// Places of the rim's vertices in the square [-1, 1]^2: (sideways, towards the left of the way).
std::vector<Vec2> square_places(const CupPlan& plan) {
  std::vector<Vec2> places;
  const int p = plan.window_columns;
  const int q = plan.window_rows;
  for (int i = 0; i < p; ++i) places.emplace_back(2.0 * i / p - 1.0, -1.0);
  for (int i = 0; i < q; ++i) places.emplace_back(1.0, 2.0 * i / q - 1.0);
  for (int i = p; i > 0; --i) places.emplace_back(2.0 * i / p - 1.0, 1.0);
  for (int i = q; i > 0; --i) places.emplace_back(-1.0, 2.0 * i / q - 1.0);
  return places;
}

Vec2 rim_centre(const TriangleMesh& mesh, const std::vector<std::int32_t>& rim) {
  Vec2 sum = Vec2::Zero();
  for (const std::int32_t v : rim) sum += Vec2(mesh.positions[v].x(), mesh.positions[v].z());
  return sum / static_cast<double>(rim.size());
}

/// Centre line in the plane y = 0: a cubic that leaves and meets the wall level.
struct HandlePath {
  std::array<Vec2, 4> control;
  Vec2 at(double u) const {
    const double v = 1.0 - u;
    return v * v * v * control[0] + 3.0 * v * v * u * control[1] + 3.0 * v * u * u * control[2] +
           u * u * u * control[3];
  }
  Vec2 direction(double u) const {
    const double v = 1.0 - u;
    const Vec2 d = v * v * (control[1] - control[0]) + 2.0 * v * u * (control[2] - control[1]) +
                   u * u * (control[3] - control[2]);
    return d / std::sqrt(d.squaredNorm());
  }
  /// n + 1 parameters at even lengths.
  std::vector<double> even_steps(int n) const {
    constexpr int kSteps = 1024;
    std::vector<double> length(kSteps + 1, 0.0);
    for (int i = 0; i < kSteps; ++i) {
      const Vec2 step =
          at(static_cast<double>(i + 1) / kSteps) - at(static_cast<double>(i) / kSteps);
      length[i + 1] = length[i] + std::sqrt(step.squaredNorm());
    }
    std::vector<double> steps;
    int i = 0;
    for (int k = 0; k <= n; ++k) {
      const double wanted = length.back() * k / n;
      while (i + 1 < kSteps && length[i + 1] < wanted) ++i;
      steps.push_back((i + (wanted - length[i]) / (length[i + 1] - length[i])) / kSteps);
    }
    return steps;
  }
};

void add_handle(TriangleMesh& mesh, const std::vector<Ring>& rings, const CupPlan& plan,
                const Window& low, const Window& high) {
  const std::vector<std::int32_t> start = window_rim(rings, plan, low);
  const std::vector<std::int32_t> end = arriving_rim(rings, plan, high);
  const std::vector<Vec2> places = square_places(plan);
  const int n = static_cast<int>(start.size());
  const Vec2 p0 = rim_centre(mesh, start);
  const Vec2 p3 = rim_centre(mesh, end);
  const Vec2 out(kHandleReach / 0.75, 0.0);
  const HandlePath path = {{p0, p0 + out, p3 + out, p3}};
  const std::vector<double> steps = path.even_steps(plan.handle_rows);
  const double length = 0.135;
  // Each rim vertex against the flat rectangle it stands for; fades along the blend.
  std::vector<std::int32_t> below = start;
  for (int k = 1; k <= plan.handle_rows; ++k) {
    std::vector<std::int32_t> above = end;
    if (k < plan.handle_rows) {
      const double from_end = std::min(k, plan.handle_rows - k) * length / plan.handle_rows;
      const double x = std::min(from_end / kBlendLength, 1.0);
      const double blend = x * x * (3.0 - 2.0 * x);
      const bool near_start = 2 * k < plan.handle_rows;
      const std::vector<std::int32_t>& rim = near_start ? start : end;
      const Vec2 origin = near_start ? p0 : p3;
      const Vec2 centre = path.at(steps[k]);
      const Vec2 d = path.direction(steps[k]);
      const Vec2 left(-d.y(), d.x());
      std::vector<Vec3> section;
      for (int j = 0; j < n; ++j) {
        const Vec2& s = places[j];
        const Vec3& at_rim = mesh.positions[rim[j]];
        // the way goes out at the start and in at the end
        const double turn = near_start ? 1.0 : -1.0;
        const double across = at_rim.y();
        const double up = turn * (at_rim.z() - origin.y());
        const double ahead = turn * (at_rim.x() - origin.x());
        const double y =
            across +
            blend * (kHandleHalfWidth * s.x() * std::sqrt(1.0 - 0.5 * s.y() * s.y()) - across);
        const double w =
            up + blend * (kHandleHalfThickness * s.y() * std::sqrt(1.0 - 0.5 * s.x() * s.x()) - up);
        const Vec2 p = centre + left * w + d * (ahead * (1.0 - blend));
        section.emplace_back(p.x(), y, p.y());
      }
      const Ring ring = add_ring(mesh, section);
      for (int j = 0; j < n; ++j) above[j] = ring.first + j;
    }
    for (int j = 0; j < n; ++j) {
      const int i = (j + 1) % n;
      mesh.triangles.push_back({below[j], below[i], above[i]});
      mesh.triangles.push_back({below[j], above[i], above[j]});
    }
    below = above;
  }
}

}  // namespace

TriangleMesh make_cup(int triangles) {
  const GridCounts counts = nearest_counts(triangles, 0.85, 1, 12, [](int around, int along) {
    return count_triangles(plan_cup(around, along));
  });
  const CupPlan plan = plan_cup(counts.around, counts.along);
  TriangleMesh mesh;
  std::vector<Ring> rings;
  const int half = plan.window_columns / 2;
  for (const Vec2& p : wall_profile(plan)) {
    std::vector<Vec3> circle;
    for (int i = 0; i < plan.around; ++i) {
      const SinCos a =
          sin_cos(2.0 * kPi * (i - half - 0.5 * (plan.window_columns % 2)) / plan.around);
      circle.emplace_back(p.x() * a.cos, p.x() * a.sin, p.y());
    }
    rings.push_back(add_ring(mesh, circle));
  }
  const double row = (kHeight - 0.5 * kWall) / plan.wall_rows;
  const auto window_at = [&](double z) {
    const int first = static_cast<int>(z / row - 0.5 * plan.window_rows + 0.5);
    return Window{std::clamp(first, 1, plan.wall_rows - plan.window_rows - 1)};
  };
  const Window low = window_at(kLowJoint);
  const Window high = window_at(kHighJoint);
  const auto in_window = [&](int k, int j) {
    const bool in_rows = (k >= low.first_row && k < low.first_row + plan.window_rows) ||
                         (k >= high.first_row && k < high.first_row + plan.window_rows);
    return in_rows && j < plan.window_columns;
  };
  for (int k = 0; k + 1 < static_cast<int>(rings.size()); ++k) {
    for (int j = 0; j < plan.around; ++j) {
      if (in_window(k, j)) continue;
      const int i = (j + 1) % plan.around;
      const std::int32_t a = rings[k].first, c = rings[k + 1].first;
      mesh.triangles.push_back({a + j, a + i, c + i});
      mesh.triangles.push_back({a + j, c + i, c + j});
    }
  }
  close_ring(mesh, rings.front(), Vec3::Zero(), true);
  close_ring(mesh, rings.back(), Vec3(0.0, 0.0, kFloor), false);
  add_handle(mesh, rings, plan, low, high);
  // Vertices inside the windows are of no triangle.
  std::vector<std::int32_t> renamed(mesh.positions.size(), -1);
  std::vector<Vec3> kept;
  for (auto& t : mesh.triangles) {
    for (std::int32_t& v : t) {
      if (renamed[v] < 0) {
        renamed[v] = static_cast<std::int32_t>(kept.size());
        kept.push_back(mesh.positions[v]);
      }
      v = renamed[v];
    }
  }
  mesh.positions = std::move(kept);
  return mesh;
}

Vec3 cup_handle_opening() {
  const double z = 0.5 * (kLowJoint + kHighJoint);
  return {outer_radius(z) + 0.5 * (kHandleReach - kHandleHalfThickness), 0.0, z};
}

}  // namespace thigma::models
