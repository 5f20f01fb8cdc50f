#include "thigma/math/elementary.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

// Reduction to a small interval, then Taylor polynomials long enough for double precision
// (evaluated by Horner in a fixed order). Slower than the C library by a factor of two; called a
// few times a tick.

namespace thigma {
namespace {

// pi/2 in three parts; the first two have 33 bits, so k * part is exact for |k| < 2^20 (|x| <=
// 1e5).
constexpr double kHalfPiA = 1.57079632673412561417e+00;
constexpr double kHalfPiB = 6.07710050630396597660e-11;
constexpr double kHalfPiC = 2.02226624879595063154e-21;

double sin_kernel(double x) {  // |x| <= pi/4
  const double z = x * x;
  double s = 1.0 / 355687428096000.0;  // 17!
  s = s * z - 1.0 / 1307674368000.0;   // 15!
  s = s * z + 1.0 / 6227020800.0;      // 13!
  s = s * z - 1.0 / 39916800.0;        // 11!
  s = s * z + 1.0 / 362880.0;          // 9!
  s = s * z - 1.0 / 5040.0;            // 7!
  s = s * z + 1.0 / 120.0;             // 5!
  s = s * z - 1.0 / 6.0;               // 3!
  return x + x * (z * s);
}

double cos_kernel(double x) {  // |x| <= pi/4
  const double z = x * x;
  double s = -1.0 / 6402373705728000.0;  // 18!
  s = s * z + 1.0 / 20922789888000.0;    // 16!
  s = s * z - 1.0 / 87178291200.0;       // 14!
  s = s * z + 1.0 / 479001600.0;         // 12!
  s = s * z - 1.0 / 3628800.0;           // 10!
  s = s * z + 1.0 / 40320.0;             // 8!
  s = s * z - 1.0 / 720.0;               // 6!
  s = s * z + 1.0 / 24.0;                // 4!
  return 1.0 - (0.5 * z - z * z * s);
}

double atan_kernel(double x) {  // |x| <= 1/16
  const double z = x * x;
  double s = 1.0 / 17.0;
  s = 1.0 / 15.0 - z * s;
  s = 1.0 / 13.0 - z * s;
  s = 1.0 / 11.0 - z * s;
  s = 1.0 / 9.0 - z * s;
  s = 1.0 / 7.0 - z * s;
  s = 1.0 / 5.0 - z * s;
  s = 1.0 / 3.0 - z * s;
  return x - x * (z * s);
}

// atan(i / 8), i = 0..8.
constexpr double kAtanTable[9] = {0.0,
                                  0.12435499454676143503,
                                  0.24497866312686415417,
                                  0.35877067027057222039,
                                  0.46364760900080611621,
                                  0.55859931534356243597,
                                  0.64350110879328438680,
                                  0.71882999962162450541,
                                  0.78539816339744830961};

double atan_unit(double t) {  // 0 <= t <= 1
  const int i = static_cast<int>(t * 8.0 + 0.5);
  const double c = static_cast<double>(i) * 0.125;
  return kAtanTable[i] + atan_kernel((t - c) / (1.0 + t * c));
}

}  // namespace

SinCos sin_cos(double x) THIGMA_RT {
  if (!(std::fabs(x) < 1e15)) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  const double k = std::floor(x * (2.0 / kPi) + 0.5);
  const double r = ((x - k * kHalfPiA) - k * kHalfPiB) - k * kHalfPiC;
  const double s = sin_kernel(r);
  const double c = cos_kernel(r);
  switch (static_cast<std::int64_t>(k) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double arc_tangent2(double y, double x) THIGMA_RT {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  if (ax == 0.0 && ay == 0.0) return 0.0;
  double a = 0.0;
  if (std::isinf(ax) && std::isinf(ay)) {
    a = kPi / 4.0;
  } else {
    a = ay <= ax ? atan_unit(ay / ax) : kPi / 2.0 - atan_unit(ax / ay);
  }
  if (x < 0.0) a = kPi - a;
  return std::signbit(y) ? -a : a;
}

double exponential(double x) THIGMA_RT {
  if (std::isnan(x)) return x;
  if (x > 709.0) return std::numeric_limits<double>::infinity();
  if (x < -745.0) return 0.0;
  // e^x = 2^k e^r with |r| <= ln(2)/2; ln 2 in two parts so that k * part is exact.
  constexpr double kLn2A = 6.93147180369123816490e-01;
  constexpr double kLn2B = 1.90821492927058770002e-10;
  const double k = std::floor(x * 1.44269504088896340736 + 0.5);
  const double r = (x - k * kLn2A) - k * kLn2B;
  double s = 1.0;
  for (int i = 14; i >= 1; --i) s = 1.0 + r * s / static_cast<double>(i);
  return std::ldexp(s, static_cast<int>(k));
}

}  // namespace thigma
