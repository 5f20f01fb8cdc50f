// The disk's rim and the wave meet where their slopes do. With s = R sin(phi) every candidate is a
// maximum of a cos(k (u + s)) + R cos(phi) between two neighbouring samples, found by bisection of
// the derivative.
#include "reference/offset_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/math/elementary.h"

namespace thigma {
namespace {

struct Wave {
  double radius = 0.0, amplitude = 0.0, k = 0.0, at = 0.0;

  double height(double phi) const noexcept {
    const SinCos p = sin_cos(phi);
    return amplitude * cosine(k * (at + radius * p.sin)) + radius * p.cos;
  }
  // d height/d phi over the radius.
  double slope(double phi) const noexcept {
    const SinCos p = sin_cos(phi);
    return -amplitude * k * sine(k * (at + radius * p.sin)) * p.cos - p.sin;
  }
};

// The maximum between low and high, where the derivative falls through 0.
double peak_between(const Wave& wave, double low, double high) noexcept {
  constexpr int kBits = 60;
  for (int i = 0; i < kBits; ++i) {
    const double middle = 0.5 * (low + high);
    (wave.slope(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Samples of a half turn: enough for every maximum of the sum to have its own.
int sample_count(const Wave& wave) noexcept {
  constexpr double kFewest = 256.0, kMost = 1e7;
  const double waves = wave.k * wave.radius / kPi;
  return static_cast<int>(std::clamp(64.0 * waves, kFewest, kMost));
}

}  // namespace

OffsetHeight disk_on_wave(double radius, double amplitude, double wavelength, double at) noexcept {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Wave wave{radius, amplitude, 2.0 * kPi / wavelength, std::remainder(at, wavelength)};
  const bool is_usable = radius > 0.0 && wavelength > 0.0 && std::isfinite(wavelength) &&
                         std::isfinite(wave.k * radius) && std::isfinite(amplitude * wave.k) &&
                         std::isfinite(wave.at);
  if (!is_usable) return {nan, nan};
  const int count = sample_count(wave);
  const double step = kPi / count;
  double best = -std::numeric_limits<double>::infinity(), best_phi = 0.0;
  double before = wave.slope(-0.5 * kPi);
  for (int i = 1; i <= count; ++i) {
    const double phi = -0.5 * kPi + i * step;
    const double after = wave.slope(phi);
    if (before > 0.0 && after <= 0.0) {
      const double peak = peak_between(wave, phi - step, phi);
      const double height = wave.height(peak);
      if (height > best) {
        best = height;
        best_phi = peak;
      }
    }
    before = after;
  }
  const double contact = wave.at + radius * sine(best_phi);
  return {best - radius, -amplitude * wave.k * sine(wave.k * contact)};
}

}  // namespace thigma
