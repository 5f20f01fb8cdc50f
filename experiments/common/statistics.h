#pragma once
// The statistics that claims are made of. Offline, plain double arithmetic, no failure: where the
// data do not determine a number it is NaN, and a claim made of it does not hold. Quantiles:
// thigma/math/quantile.h.

#include <span>
#include <vector>

namespace thigma::experiments {

double mean(std::span<const double> x);                      // NaN of nothing
double root_mean_square(std::span<const double> x);          // NaN of nothing
double standard_deviation(std::span<const double> x);        // of the sample, n - 1; NaN below two
double coefficient_of_variation(std::span<const double> x);  // standard deviation / mean

/// Pearson's correlation; NaN when either does not vary or the lengths differ.
double correlation(std::span<const double> x, std::span<const double> y);
/// Spearman's: of the ranks, equal values sharing the mean of theirs.
double rank_correlation(std::span<const double> x, std::span<const double> y);
/// The same where each pair counts as often as its weight says, which need not be whole; weights >=
/// 0.
double rank_correlation(std::span<const double> x, std::span<const double> y,
                        std::span<const double> weight);

/// Root mean square of x - y over that of y.
double relative_error(std::span<const double> x, std::span<const double> y);

/// y = slope x + intercept by least squares, with the 95 % interval of the slope (Student's t).
struct LineFit {
  double slope = 0.0, intercept = 0.0;
  double slope_low = 0.0, slope_high = 0.0;  // infinite with two points
  double r_squared = 0.0;
};
LineFit fit_line(std::span<const double> x, std::span<const double> y);
/// The same over logarithms: slope is the exponent of y ~ x^slope. Pairs that are not positive are
/// left out.
LineFit fit_power(std::span<const double> x, std::span<const double> y);
/// y = scale x, without a constant: the share of y's variance about its mean that is explained; may
/// be negative.
double proportional_r_squared(std::span<const double> x, std::span<const double> y);

/// Low pass without delay: Butterworth of second order, forwards and backwards, ends continued by
/// point reflection.
/// step, cutoff  of the samples [s], half power once (-6 dB for both passes) [Hz]; cutoff < 0.5 /
///               step
std::vector<double> low_pass(std::span<const double> x, double step, double cutoff);
/// Second central difference over step^2; two shorter than x.
std::vector<double> second_derivative(std::span<const double> x, double step);
/// Root mean square of x within [low, high] Hz, by a discrete Fourier sum under a Hann window, mean
/// removed.
double band_level(std::span<const double> x, double step, double low, double high);
/// Within the same band, how much of a reference is in x: the factor of least squares from the
/// reference to x. 1 for the reference itself, 0 for what has nothing to do with it, however
/// strong; NaN where the reference is silent there.
double band_share(std::span<const double> x, std::span<const double> reference, double step,
                  double low, double high);

}  // namespace thigma::experiments
