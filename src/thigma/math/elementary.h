#pragma once
// Sine, cosine and arc tangent with the same bits on every x86-64 machine.
//
// The C library picks other code paths on processors with fused multiply-add, and their last digits
// differ; a state hash must not. Everything that reaches a state, a model or a file uses these.
// std::sqrt, fabs, floor are exact by IEEE 754 and stay.

#include "thigma/core/rt.h"

namespace thigma {

inline constexpr double kPi = 3.14159265358979323846;

struct SinCos {
  double sin = 0.0;
  double cos = 1.0;
};

/// Sine and cosine of x [rad]; absolute error <= 2e-16 for |x| <= 1e5, NaN for NaN and infinities.
/// Thread    [haptic].
SinCos sin_cos(double x) THIGMA_RT;
inline double sine(double x) THIGMA_RT { return sin_cos(x).sin; }
inline double cosine(double x) THIGMA_RT { return sin_cos(x).cos; }

/// Angle of the point (x, y) in (-pi, pi] [rad]; relative error <= 1e-15; 0 for (0, 0).
/// Thread    [haptic].
double arc_tangent2(double y, double x) THIGMA_RT;

/// e^x, relative error <= 1e-15; 0 below -745, infinity above 709.
/// Thread    [haptic].
double exponential(double x) THIGMA_RT;

}  // namespace thigma
