#pragma once
// The shape of the two jaws as heights over the dental arch.

#include <cstdint>
#include <vector>

#include "thigma/math/types.h"

namespace thigma::models {

/// Centre line of the dental arch: half an ellipse in the plane z = 0, open towards -y, by arc
/// length.
struct DentalArch {
  std::vector<double> angles;  // at evenly spaced arc lengths, -pi/2 .. pi/2 [rad]
  double length = 0.0;         // [m]
};

struct ArchFrame {
  Vec2 point;    // on the centre line [m]
  Vec2 outward;  // unit normal, towards lips and cheeks
};

DentalArch make_dental_arch();
ArchFrame arch_frame(const DentalArch& arch, double s);

enum class ToothKind : std::uint8_t { incisor, canine, premolar, molar };

/// One crown in arch coordinates: s along the centre line, t outwards, z towards the other jaw. [m,
/// rad]
struct Tooth {
  ToothKind kind = ToothKind::incisor;
  double s = 0.0, t = 0.0;          // centre
  double width = 0.0, depth = 0.0;  // along s and along t
  double height = 0.0, tip = 0.0;   // crown height, and height of its tip over the occlusal plane
  double turn = 0.0;                // about z
  double cusp_scale = 1.0;          // of the occlusal relief
  double cusp_shift = 0.0;          // of its cusps, share of the half width
};

/// One jaw: teeth on a gum ridge, seen from the other jaw.
struct JawRelief {
  std::vector<Tooth> teeth;
  double length = 0.0;            // of the arch [m]
  double front_half_width = 0.0;  // of the ridge, at the incisors and at the molars [m]
  double back_half_width = 0.0;
  double phases[6] = {};  // of the gum's unevenness [rad]
};

JawRelief lower_relief(const DentalArch& arch, std::uint64_t seed);
JawRelief upper_relief(const DentalArch& arch, std::uint64_t seed);

/// Half width of the ridge at s [m].
double half_width(const JawRelief& jaw, double s);
/// Height of the surface over the occlusal plane at (s, t), |t| <= half_width [m]; towards the
/// other jaw is positive.
double surface_height(const JawRelief& jaw, double s, double t);
/// Clearance of the occlusion at (s, t): the worn facets of the upper jaw stay this far above the
/// lower [m].
double occlusal_gap(double s, double t);

/// Height where top and underside of the ridge meet, and of the flat base [m].
inline constexpr double kRidgeEdge = -15e-3;
inline constexpr double kRidgeBase = -23e-3;

}  // namespace thigma::models
