#include "thigma/models/textured_parts.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/elementary.h"

namespace thigma::models {
namespace {

constexpr double kTurn = 2.0 * kPi;

/// A corner of the half outline of a turned or extruded body: share of its section, and height.
struct Station {
  double width = 0.0;  // 0 on the axis, 1 of the full section
  double z = 0.0;      // [m]
};

/// Between stations, one a row of cells.
Station station_at(const std::vector<Station>& stations, double v) {
  const double place = v * static_cast<double>(stations.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), stations.size() - 2);
  const double t = place - static_cast<double>(i);
  const Station &a = stations[i], &b = stations[i + 1];
  return {a.width + t * (b.width - a.width), a.z + t * (b.z - a.z)};
}

/// A section between an ellipse and a box: x^4 + y^4 = 1, scaled.
Vec2 box_section(double u, double half_x, double half_y) {
  const SinCos at = sin_cos(kTurn * u);
  const double c2 = at.cos * at.cos, s2 = at.sin * at.sin;
  const double scale = 1.0 / std::sqrt(std::sqrt(c2 * c2 + s2 * s2));
  return {half_x * scale * at.cos, half_y * scale * at.sin};
}

/// Relief fades to nothing within a cell of the poles, where a sheet has no width left.
double away_from_poles(double v, int along) {
  const double cells = along * std::min(v, 1.0 - v) - 1.0;
  const double t = std::clamp(cells, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

std::vector<Station> bar_stations(double length, int rows) {
  std::vector<Station> stations = {{0.0, -0.5 * length}};
  for (int i = 0; i <= rows; ++i)
    stations.push_back({1.0, length * (static_cast<double>(i) / rows - 0.5)});
  stations.push_back({0.0, 0.5 * length});
  return stations;
}

struct Cells {
  int around = 0, along = 0;
};

/// A sheet over point(u, v, is_rough), the surface with and without relief. Its coarse corners lie
/// off the smooth one by a share of the relief, as those of a simplified scan do: about as far from
/// convex as the text's coarse models.
template <class Point>
TexturedSheet sheet_of(const Point& point, Cells coarse, Cells fine) {
  TexturedSheet sheet;
  sheet.fine = [point](double u, double v) { return point(u, v, true); };
  sheet.smooth = [point](double u, double v) { return point(u, v, false); };
  // Any share makes as many patches; the more, the farther corners are from where the fine surface
  // is on average.
  sheet.coarse = [point](double u, double v) {
    constexpr double kShare = 0.2;
    const Vec3 smooth = point(u, v, false), rough = point(u, v, true);
    return Vec3(smooth + kShare * (rough - smooth));
  };
  sheet.around = coarse.around;
  sheet.along = coarse.along;
  sheet.fine_around = fine.around;
  sheet.fine_along = fine.along;
  return sheet;
}

/// Cross-cut file: 200 x 22 x 6 mm, cuts of 0.3 mm, 3 mm apart, on both broad sides.
TexturedSheet file_sheet() {
  const std::vector<Station> stations = bar_stations(0.200, 38);
  const auto point = [stations](double u, double v, bool is_rough) {
    const Station s = station_at(stations, v);
    const Vec2 at = s.width * box_section(u, 0.011, 0.003);
    if (!is_rough) return Vec3(at.x(), at.y(), s.z);
    const double across = at.x() / 0.003, along = s.z / 0.003;
    const double cut =
        0.5 * (sine(kTurn * (along + across)) + sine(kTurn * (along - 0.7 * across)));
    const double side = std::clamp(at.y() / 0.003, -1.0, 1.0);
    return Vec3(at.x(), at.y() + 1.5e-4 * cut * side * away_from_poles(v, 40), s.z);
  };
  return sheet_of(point, {8, 40}, {352, 407});
}

/// Flange with a boss, 100 x 100 x 45 mm, rough all over: waves of 5 mm, 0.3 mm high.
TexturedSheet cad_sheet() {
  const std::vector<Station> stations = {
      {0.0, 0.0},    {0.35, 0.0},   {0.7, 0.0},    {0.97, 0.0},   {1.0, 0.004},  {1.0, 0.012},
      {1.0, 0.021},  {0.97, 0.025}, {0.80, 0.025}, {0.63, 0.025}, {0.48, 0.026}, {0.44, 0.030},
      {0.42, 0.037}, {0.40, 0.044}, {0.36, 0.046}, {0.18, 0.046}, {0.0, 0.046}};
  const auto point = [stations](double u, double v, bool is_rough) {
    const Station s = station_at(stations, v);
    const Vec2 at = s.width * box_section(u, 0.050, 0.050);
    if (!is_rough) return Vec3(at.x(), at.y(), s.z);
    // Up on level parts, outwards on steep ones.
    const Station before = station_at(stations, std::max(v - 0.01, 0.0)),
                  after = station_at(stations, std::min(v + 0.01, 1.0));
    const Vec2 along(0.05 * (after.width - before.width), after.z - before.z);
    const double steep = along.norm() > 0.0 ? along.y() / along.norm() : 0.0;
    const double level = along.norm() > 0.0 ? -along.x() / along.norm() : 0.0;
    const Vec2 out = at.norm() > 0.0 ? Vec2(at.normalized()) : Vec2(Vec2::Zero());
    const double wave = sine(kTurn * at.x() / 0.005) * sine(kTurn * at.y() / 0.0055) +
                        0.5 * sine(kTurn * s.z / 0.004);
    const double d = 1.5e-4 * wave * away_from_poles(v, 16);
    return Vec3(at.x() + d * steep * out.x(), at.y() + d * steep * out.y(), s.z + d * level);
  };
  return sheet_of(point, {24, 16}, {512, 644});
}

/// A bar of round section along an axis: 0 x, 2 z; with knobs.
TexturedSheet bar_sheet(const std::vector<Station>& stations, double radius, int axis,
                        const Vec3& middle, double knob) {
  const int along = static_cast<int>(stations.size()) - 1;
  const auto point = [=](double u, double v, bool is_rough) {
    const Station s = station_at(stations, v);
    const SinCos at = sin_cos(kTurn * u);
    const double relief = knob * sine(kTurn * 12.0 * u) * sine(kTurn * s.z / 0.006);
    const double r = s.width * (radius + (is_rough ? relief * away_from_poles(v, along) : 0.0));
    const Vec3 p(r * at.cos, r * at.sin, s.z);
    return Vec3(middle + (axis == 2 ? p : Vec3(p.z(), p.x(), p.y())));
  };
  return sheet_of(point, {18, along}, {256, 424});
}

/// Head of 90 x 30 mm across a handle of 220 mm: two components.
std::vector<TexturedSheet> hammer_sheets() {
  const std::vector<Station> head = {{0.0, -0.045}, {0.5, -0.045},  {0.9, -0.043},
                                     {1.0, -0.038}, {0.95, -0.012}, {0.95, 0.012},
                                     {1.0, 0.038},  {0.9, 0.043},   {0.0, 0.045}};
  const std::vector<Station> handle = {{0.0, -0.220}, {0.9, -0.220},  {1.0, -0.190},
                                       {0.9, -0.140}, {0.85, -0.100}, {0.8, -0.060},
                                       {0.8, -0.030}, {0.8, 0.018},   {0.0, 0.018}};
  return {bar_sheet(head, 0.015, 0, Vec3::Zero(), 2e-4),
          bar_sheet(handle, 0.010, 2, Vec3::Zero(), 3e-4)};
}

/// Ring of 120 mm with a tube of 40 mm, wound about by ridges of 0.6 mm.
TexturedSheet torus_sheet() {
  const auto point = [](double u, double v, bool is_rough) {
    const SinCos a = sin_cos(kTurn * u), b = sin_cos(kTurn * v);
    const double r = 0.020 + (is_rough ? 3e-4 : 0.0) * sine(kTurn * (40.0 * u + 6.0 * v));
    const double out = 0.060 + r * b.cos;
    return Vec3(out * a.cos, out * a.sin, r * b.sin);
  };
  TexturedSheet sheet = sheet_of(point, {19, 14}, {320, 200});
  sheet.is_ring = true;
  return sheet;
}

}  // namespace

TexturedSheet make_gear_sheet(const RidgeProfile& teeth) {
  constexpr double kHalfWidth = 0.012, kTooth = 0.5 * kRidgeHeight;
  constexpr int kTeeth = 25, kRows = 5;  // of the rim
  constexpr double kRadius = kTeeth * kRidgePitch / kTurn, kRoot = (kRadius - kTooth) / kRadius;
  // The teeth rise from the root over the first and last row of the rim: no edge of the coarse
  // wheel lies under relief.
  std::vector<Station> stations = {{0.0, -kHalfWidth}, {0.33, -kHalfWidth}, {0.66, -kHalfWidth}};
  for (int i = 0; i <= kRows; ++i)
    stations.push_back({i == 0 || i == kRows ? kRoot : 1.0, kHalfWidth * (2.0 * i / kRows - 1.0)});
  for (const double width : {0.66, 0.33, 0.0}) stations.push_back({width, kHalfWidth});
  const auto point = [stations, teeth](double u, double v, bool is_rough) {
    const Station s = station_at(stations, v);
    const double height = std::clamp(0.5 * kRows * (1.0 - std::fabs(s.z) / kHalfWidth), 0.0, 1.0);
    // A groove, not a flank, half way around.
    const double tooth = is_rough ? kTooth * height * teeth(kTeeth * u + 0.25) : 0.0;
    const double r = s.width * kRadius + tooth;
    const SinCos at = sin_cos(kTurn * u);
    return Vec3(r * at.cos, r * at.sin, s.z);
  };
  TexturedSheet sheet = sheet_of(point, {80, 11}, {400, 33});
  sheet.coarse = sheet.smooth;
  return sheet;
}

std::vector<TexturedSheet> textured_part(std::string_view name) {
  if (name == "file") return {file_sheet()};
  if (name == "cad_part") return {cad_sheet()};
  if (name == "hammer") return hammer_sheets();
  if (name == "helicoidal_torus") return {torus_sheet()};
  if (name == "gear") return {make_gear_sheet([](double turns) { return flat_ridge(turns); })};
  return {};
}

}  // namespace thigma::models
