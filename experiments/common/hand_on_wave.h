#pragma once
// A hand that drags a round probe over a wave (Sec. 4.5.1): what it shakes like.

#include <functional>
#include <string>
#include <vector>

#include "experiments/common/experiment.h"

namespace thigma::experiments {

/// The hand, the probe and how it is led. The text gives no number: these are the reference set of
/// the project's notes.
struct WaveStroke {
  double amplitude = 1e-4;    // of the wave [m]
  double diameter = 3e-3;     // of the probe [m]
  double normal_force = 0.5;  // N [N]
  double speed = 0.1;         // v [m/s]
  double mass = 0.1;          // m_h [kg]
  double stiffness = 300.0;   // k_h [N/m]
  double damping_ratio = 0.5;
};

/// Slope of the depth by the probe's place over one wavelength, at equal distances from 0 on.
struct SlopeTable {
  double wavelength = 0.0;     // [m]
  std::vector<double> slopes;  // [-]
};

/// In closed form: disk_on_wave.
SlopeTable exact_slopes(const WaveStroke& stroke, double wavelength);

/// As the contact step has it: a ball held into a textured plate, its depth term's gradient.
SlopeTable pipeline_slopes(const WaveStroke& stroke, double wavelength, int places);

/// Largest acceleration of the hand along the surface in the second half of two seconds.
///
/// Source  Eqs. 4.11-4.14: m u'' = k (v t - u) + b (v - u') - N d depth/du, docs/sources.md
double largest_acceleration(const WaveStroke& stroke, const SlopeTable& table);

/// One curve of Figs. 4.8 to 4.10.
struct Roughness {
  WaveStroke stroke;
  std::string label;
  std::vector<double> spacing{}, acceleration{};  // [m, m/s^2]
  double peak_spacing = 0.0, peak = 0.0;  // of a parabola through the largest three, in logarithms
};

/// Curves over wavelengths of 0.4 to 12 mm.
/// through_pipeline  slopes by the contact step instead of the closed form
std::vector<Roughness> roughness_curves(const Context& context, std::vector<Roughness> curves,
                                        bool through_pipeline);

/// R^2 of a parabola through the logarithms between 0.5 and 5 mm.
double quadratic_fit(const Roughness& curve);

/// Figs. 4.8 to 4.10: the curves in closed form and through the contact step, with tables, panels
/// and claims of both.
/// add_claims  of one of the two; suffix of the ids, how the curves came about
Outcome run_roughness(const Context& context, const std::string& title,
                      const std::vector<Roughness>& curves,
                      void (*add_claims)(const std::string& suffix, const std::string& how,
                                         const std::vector<Roughness>& curves, Outcome& outcome));

/// Acceleration of a curve at a wavelength, between the nearest in logarithms.
double acceleration_at(const Roughness& curve, double spacing);

}  // namespace thigma::experiments
