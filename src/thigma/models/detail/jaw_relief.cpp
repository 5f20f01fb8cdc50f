// A jaw is a height over arch coordinates, so its surface cannot cross itself. Crown sizes are
// rounded human averages; the seed moves them by a few percent. Heights are in metres over the
// occlusal plane.

#include "thigma/models/detail/jaw_relief.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"

namespace thigma::models {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kArchHalfWidth = 26.0 * kMillimetre;
constexpr double kArchDepth = 47.0 * kMillimetre;
constexpr int kArchSteps = 4096;
constexpr double kGumCrest = -7.6 * kMillimetre;

/// Average crown: kind, width, depth, height, tip, offset from the centre line [mm].
struct CrownSize {
  ToothKind kind;
  double width, depth, height, tip, offset;
};

// From the midline backwards, one side.
constexpr CrownSize kLowerCrowns[] = {
    {ToothKind::incisor, 5.3, 6.4, 9.3, 1.2, -1.4},
    {ToothKind::incisor, 5.7, 6.6, 9.3, 1.2, -1.2},
    {ToothKind::canine, 6.9, 7.8, 10.2, 1.7, -0.9},
    {ToothKind::premolar, 7.0, 8.0, 8.9, 1.1, -0.8},
    {ToothKind::premolar, 7.2, 8.6, 8.5, 0.9, -0.8},
    {ToothKind::molar, 11.0, 10.6, 8.2, 0.8, -0.8},
    {ToothKind::molar, 10.5, 10.4, 8.0, 0.9, -0.8},
};
constexpr CrownSize kUpperCrowns[] = {
    {ToothKind::incisor, 8.2, 7.0, 10.4, 2.6, 1.4}, {ToothKind::incisor, 6.4, 6.6, 10.0, 2.3, 1.4},
    {ToothKind::canine, 7.4, 8.2, 10.6, 2.5, 1.5},  {ToothKind::premolar, 6.8, 9.2, 9.3, 1.7, 1.3},
    {ToothKind::premolar, 6.6, 9.4, 9.1, 1.6, 1.3}, {ToothKind::molar, 9.9, 11.2, 8.7, 1.4, 1.3},
    {ToothKind::molar, 9.3, 11.0, 8.5, 1.4, 1.2},
};

double square(double x) { return x * x; }

/// |x| with its corner rounded within about `radius`.
double soft_abs(double x, double radius) { return std::sqrt(x * x + radius * radius) - radius; }

/// max(a, b) with the crease between them filled within `blend`.
double soft_max(double a, double b, double blend) {
  const double h = std::max(blend - std::fabs(a - b), 0.0) / blend;
  return std::max(a, b) + 0.25 * h * h * blend;
}

double bump(double a, double b, double spread) {
  return exponential(-0.5 * (square(a) + square(b)) / square(spread));
}

/// Occlusal relief as a share of the crown height, 1 at a tip; (a, b) = half widths along and
/// outwards.
double occlusal_share(const Tooth& tooth, double a, double b) {
  const double k = tooth.cusp_scale;
  const double c = tooth.cusp_shift;
  switch (tooth.kind) {
    case ToothKind::incisor:
      return 1.0 - 0.80 * soft_abs(b - 0.12, 0.08) - 0.03 * a * a + 0.008 * cosine(3.0 * kPi * a);
    case ToothKind::canine:
      return 1.0 - 0.24 * k * soft_abs(a - c, 0.12) - 0.62 * soft_abs(b - 0.1, 0.2);
    case ToothKind::premolar:
      return 0.68 + 0.33 * k * bump(a - c, b - 0.46, 0.34) + 0.25 * k * bump(a + c, b + 0.5, 0.32) -
             0.07 * bump(0.0, b + 0.02, 0.12);
    case ToothKind::molar:
      return 0.69 + 0.28 * k * bump(a - 0.46 - c, b - 0.47, 0.27) +
             0.29 * k * bump(a + 0.42 - c, b - 0.47, 0.26) +
             0.27 * k * bump(a - 0.45 + c, b + 0.48, 0.27) +
             0.25 * k * bump(a + 0.45 + c, b + 0.46, 0.27) - 0.06 * bump(a - c, 0.0, 0.09) -
             0.08 * bump(0.0, b, 0.10) - 0.04 * bump(a - 0.1, b - 0.1, 0.3);
  }
  return 0.0;
}

/// Place of (s, t) in the crown: half widths from its centre.
Vec2 crown_place(const Tooth& tooth, double s, double t) {
  const SinCos turn = sin_cos(tooth.turn);
  const double ds = s - tooth.s;
  const double dt = t - tooth.t;
  return {2.0 * (turn.cos * ds + turn.sin * dt) / tooth.width,
          2.0 * (turn.cos * dt - turn.sin * ds) / tooth.depth};
}

double crown_height(const Tooth& tooth, const Vec2& place) {
  // Neighbours meet at 0.93 of the half width, well above the gum: the contact points of a real row
  // of teeth.
  const double a = 0.93 * place.x();
  const double b = place.y();
  const double a2 = a * a;
  const double b2 = b * b;
  const double r4 = 0.55 * (a2 * a2 + b2 * b2) + 0.45 * square(a2 + b2);
  const double wall = std::max(1.0 - r4 * r4, -1.5);
  const double share = wall > 0.0 ? wall * occlusal_share(tooth, a, b) : wall;
  return tooth.tip - tooth.height * (1.0 - share);
}

/// 0 at the ends of the arch, 1 from `reach` inwards, rounded like a quarter of a circle.
double end_rounding(const JawRelief& jaw, double s, double reach) {
  const double x = std::clamp(std::min(s, jaw.length - s) / reach, 0.0, 1.0);
  return std::sqrt(1.0 - square(1.0 - x));
}

double gum_height(const JawRelief& jaw, double s, double t) {
  const double u = std::min(std::fabs(t) / half_width(jaw, s), 1.0);
  const double u2 = u * u;
  const double dome = std::sqrt(std::sqrt(1.0 - u2 * u2));
  // Papillae: the gum climbs between the teeth and sinks before each.
  double papilla = 0.0;
  double nearest = 1e9;
  for (const Tooth& tooth : jaw.teeth) {
    const double a = std::fabs(2.0 * (s - tooth.s) / tooth.width);
    if (a < nearest) nearest = a;
  }
  if (nearest <= 1.0) papilla = 0.9 * kMillimetre * (square(nearest) - 1.0);
  double uneven = 0.0;
  for (int i = 0; i < 6; ++i)
    uneven += sine((180.0 + 95.0 * i) * s + jaw.phases[i] + 220.0 * (i % 3) * t);
  const double end = end_rounding(jaw, s, 6.0 * kMillimetre);
  const double rise =
      (kGumCrest - kRidgeEdge) * (0.45 + 0.55 * end) + 0.07 * kMillimetre * uneven * end;
  return kRidgeEdge + rise * dome + papilla * (1.0 - u2);
}

JawRelief make_relief(const DentalArch& arch, const CrownSize (&crowns)[7], std::uint64_t seed) {
  JawRelief jaw;
  jaw.length = arch.length;
  Random random(seed);
  const auto vary = [&](double share) { return 1.0 + random.uniform(-share, share); };
  for (int side = -1; side <= 1; side += 2) {
    double s = 0.5 * arch.length;
    for (const CrownSize& crown : crowns) {
      Tooth tooth;
      tooth.kind = crown.kind;
      tooth.width = crown.width * kMillimetre * vary(0.02);
      tooth.depth = crown.depth * kMillimetre * vary(0.03);
      tooth.tip = crown.tip * kMillimetre + random.uniform(-0.15, 0.15) * kMillimetre;
      tooth.height = crown.height * kMillimetre * vary(0.02);
      tooth.t = crown.offset * kMillimetre + random.uniform(-0.25, 0.25) * kMillimetre;
      tooth.s = s + side * 0.5 * tooth.width;
      tooth.turn = random.uniform(-0.06, 0.06);
      tooth.cusp_scale = vary(0.12);
      tooth.cusp_shift = random.uniform(-0.05, 0.05);
      s += side * tooth.width;
      jaw.teeth.push_back(tooth);
    }
  }
  for (double& phase : jaw.phases) phase = random.uniform(0.0, 2.0 * kPi);
  return jaw;
}

}  // namespace

DentalArch make_dental_arch() {
  std::vector<double> lengths(kArchSteps + 1, 0.0);
  const auto angle = [](double i) { return kPi * (i / kArchSteps - 0.5); };
  const auto point = [&](double i) {
    const SinCos a = sin_cos(angle(i));
    return Vec2(kArchHalfWidth * a.sin, kArchDepth * a.cos);
  };
  for (int i = 0; i < kArchSteps; ++i)
    lengths[i + 1] = lengths[i] + std::sqrt((point(i + 1) - point(i)).squaredNorm());
  DentalArch arch;
  arch.length = lengths.back();
  int i = 0;
  for (int k = 0; k <= kArchSteps; ++k) {
    const double s = arch.length * k / kArchSteps;
    while (i + 1 < kArchSteps && lengths[i + 1] < s) ++i;
    arch.angles.push_back(
        angle(i + std::clamp((s - lengths[i]) / (lengths[i + 1] - lengths[i]), 0.0, 1.0)));
  }
  return arch;
}

ArchFrame arch_frame(const DentalArch& arch, double s) {
  const double x = std::clamp(s / arch.length, 0.0, 1.0) * kArchSteps;
  const int i = std::min(static_cast<int>(x), kArchSteps - 1);
  const SinCos a = sin_cos(arch.angles[i] + (arch.angles[i + 1] - arch.angles[i]) * (x - i));
  const Vec2 normal(kArchDepth * a.sin, kArchHalfWidth * a.cos);
  return {Vec2(kArchHalfWidth * a.sin, kArchDepth * a.cos),
          normal / std::sqrt(normal.squaredNorm())};
}

JawRelief lower_relief(const DentalArch& arch, std::uint64_t seed) {
  JawRelief jaw = make_relief(arch, kLowerCrowns, seed);
  jaw.front_half_width = 6.0 * kMillimetre;
  jaw.back_half_width = 7.6 * kMillimetre;
  return jaw;
}

JawRelief upper_relief(const DentalArch& arch, std::uint64_t seed) {
  JawRelief jaw = make_relief(arch, kUpperCrowns, seed ^ 0x75707065722d6a61ull);
  jaw.front_half_width = 7.0 * kMillimetre;
  jaw.back_half_width = 8.4 * kMillimetre;
  return jaw;
}

double half_width(const JawRelief& jaw, double s) {
  const double x = std::fabs(2.0 * s / jaw.length - 1.0);  // 0 at the midline, 1 at the ends
  const double w =
      jaw.front_half_width + (jaw.back_half_width - jaw.front_half_width) * x * x * (3.0 - 2.0 * x);
  return w * (0.6 + 0.4 * end_rounding(jaw, s, 6.0 * kMillimetre));
}

double surface_height(const JawRelief& jaw, double s, double t) {
  double z = -1.0;
  for (const Tooth& tooth : jaw.teeth) {
    if (std::fabs(s - tooth.s) > tooth.width) continue;
    z = soft_max(z, crown_height(tooth, crown_place(tooth, s, t)), 0.25 * kMillimetre);
  }
  return soft_max(gum_height(jaw, s, t), z, 0.5 * kMillimetre);
}

double occlusal_gap(double s, double t) {
  // Facets bulge, so that a bite touches in spots of 1 to 2 mm and not all over at once.
  return (0.10 + 0.15 * (1.0 - sine(900.0 * s) * sine(1300.0 * t + 500.0 * s))) * kMillimetre;
}

}  // namespace thigma::models
