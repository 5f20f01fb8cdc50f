#pragma once
// Times every method on a pair's path, and says what each of them found.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/bench_pair.h"
#include "benchmarks/bench_rows.h"
#include "benchmarks/probe.h"

#include "thigma/contact/contact.h"
#include "thigma/contact/resolution.h"

namespace thigma::bench {

/// What one method reports at a pose, in terms all methods share.
struct Report {
  std::vector<Vec3> points;  // of the contacts [m; world]
  // smallest separation, negative in penetration; none: no contact [m]
  std::optional<double> least;
};

/// Of the exact query: a point halfway between the two of each contact.
Report report_of(const ContactSet& set);

/// Of a method whose contacts have a point and a depth.
template <class Contacts>
Report report_of_depths(const Contacts& contacts) {
  Report report;
  for (const auto& c : contacts) {
    report.points.push_back(c.point);
    report.least = std::min(report.least.value_or(-c.depth), -c.depth);
  }
  return report;
}

/// The exact contacts at a pose, and their local regions: contacts linked by steps of `reach`.
struct Truth {
  Report report;
  std::vector<int> region;  // of each point
  int regions = 0;
};

/// Exact contacts; reach is 2 % of the pair's radius.
Truth find_truth(const BenchPair& pair, const Pose& pose);

/// Compares reports with truths at the same poses. has_depth: false for methods that say 0 in
/// penetration.
Quality compare(const BenchPair& pair, const std::vector<Truth>& truths,
                const std::vector<Report>& reports, bool has_depth = true);

/// CPU time of a method over the path [us], and what it found.
struct MethodTiming {
  std::string name;
  Figure us;
  double contacts = 0.0;  // mean over the timed poses
  std::int64_t poses = 0;
  Quality quality;
  std::string note;
};

/// Time of ours, with what it did.
struct LevelTiming {
  MethodTiming method;
  double front = 0.0, tests = 0.0;  // means; nodes of the front, pairs looked at
  double cold_us = 0.0;             // the first query, from the root [us]
  std::int64_t dropped = 0, unrefined = 0;
  double apart_us = 0.0,
         meeting_us = 0.0;  // medians where it reports surfaces apart, and meeting [us]
};

/// Ours along the whole path, each pose's best of `runs` runs; the first pose is in cold_us alone.
/// checked: poses (indices of the path, rising) the quality is taken at, with its truth in
/// `truths`.
LevelTiming measure_levels(const BenchPair& pair, const std::vector<Pose>& path,
                           const Resolution& resolution, int runs,
                           const std::vector<std::size_t>& checked,
                           const std::vector<Truth>& truths);

/// The baselines; each pose's best of three. Slow ones take poses evenly along the path, as many as
/// `seconds` of CPU time allow. None where the library is absent.
MethodTiming measure_shell(const BenchPair& pair, const std::vector<Pose>& path,
                           const std::vector<std::size_t>& checked,
                           const std::vector<Truth>& truths);
std::optional<MethodTiming> measure_bullet(const BenchPair& pair, const std::vector<Pose>& path,
                                           double seconds, const std::vector<std::size_t>& checked,
                                           const std::vector<Truth>& truths);
std::optional<MethodTiming> measure_fcl(const BenchPair& pair, const std::vector<Pose>& path,
                                        double seconds, const std::vector<std::size_t>& checked,
                                        const std::vector<Truth>& truths);

}  // namespace thigma::bench
