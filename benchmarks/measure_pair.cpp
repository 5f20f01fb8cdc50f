#include "benchmarks/measure_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "benchmarks/baselines/bullet_baseline.h"
#include "benchmarks/baselines/fcl_baseline.h"
#include "benchmarks/point_cells.h"

#include "thigma/contact/query_contacts.h"
#include "thigma/math/quantile.h"

namespace thigma::bench {
namespace {

constexpr std::size_t kRoom = 400'000;  // contacts of a query of ours
constexpr std::size_t kCompared =
    20'000;                      // exact contacts of a pose that recall is taken over, at most
constexpr double kReach = 0.02;  // by the radius

// Times `query` on poses along the path, and asks `tell` for its report at the checked ones.
template <class Query, class Tell>
MethodTiming time_poses(const BenchPair& pair, const std::vector<Pose>& path, double budget,
                        const std::vector<std::size_t>& checked, const std::vector<Truth>& truths,
                        bool has_depth, Query&& query, Tell&& tell) {
  constexpr int kRuns = 3;
  MethodTiming out;
  double one = 0.0;
  for (const std::size_t i : {path.size() / 2, path.size() / 8}) {  // warm, and how long one takes
    const double start = thread_cpu();
    query(path[i]);
    one = std::max(one, thread_cpu() - start);
  }
  const double affordable = budget / (kRuns * std::max(one, 1e-9));
  const std::size_t least = std::min<std::size_t>(10, path.size());
  const std::size_t wanted = affordable >= static_cast<double>(path.size())
                                 ? path.size()
                                 : std::max(least, static_cast<std::size_t>(affordable));
  const std::size_t stride = path.size() / wanted;
  std::vector<double> best;
  for (int run = 0; run < kRuns; ++run) {
    std::size_t n = 0;
    for (std::size_t i = stride / 2; i < path.size(); i += stride, ++n) {
      const double start = thread_cpu();
      const std::size_t contacts = query(path[i]);
      const double spent = thread_cpu() - start;
      if (run == 0) {
        best.push_back(spent);
        out.contacts += static_cast<double>(contacts);
      } else {
        best[n] = std::min(best[n], spent);
      }
    }
  }
  out.poses = static_cast<std::int64_t>(best.size());
  out.contacts /= static_cast<double>(best.size());
  out.us = figure_of(best, 1e6);
  std::vector<Report> reports;
  for (const std::size_t i : checked) {
    query(path[i]);
    reports.push_back(tell());
  }
  out.quality = compare(pair, truths, reports, has_depth);
  return out;
}

}  // namespace

Report report_of(const ContactSet& set) {
  Report report;
  report.points.reserve(set.contacts.size());
  for (const Contact& c : set.contacts) report.points.push_back(0.5 * (c.point + c.scene_point));
  if (!set.contacts.empty()) report.least = least_distance(set);
  return report;
}

Truth find_truth(const BenchPair& pair, const Pose& pose) {
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(kRoom);
  query_contacts({pair.object, pose}, {pair.scene}, {.tolerance = pair.tolerance}, front, set);
  Truth truth;
  truth.report = report_of(set);
  std::vector<Vec3>& points = truth.report.points;
  if (points.size() > kCompared) {
    std::vector<Vec3> some;
    for (std::size_t i = 0; i < kCompared; ++i)
      some.push_back(points[i * points.size() / kCompared]);
    points.swap(some);
  }
  truth.region = regions_of(points, kReach * pair.radius, truth.regions);
  return truth;
}

Quality compare(const BenchPair& pair, const std::vector<Truth>& truths,
                const std::vector<Report>& reports, bool has_depth) {
  const double reach = kReach * pair.radius;
  double exact = 0.0, found = 0.0, regions = 0.0, regions_found = 0.0, error_sum = 0.0;
  Quality quality;
  for (std::size_t k = 0; k < truths.size(); ++k) {
    const Truth& truth = truths[k];
    const PointCells cells = sort_into_cells(reports[k].points, reach);
    std::vector<char> hit(static_cast<std::size_t>(truth.regions), 0);
    for (std::size_t i = 0; i < truth.report.points.size(); ++i) {
      if (!has_point_within(cells, truth.report.points[i])) continue;
      found += 1.0;
      hit[static_cast<std::size_t>(truth.region[i])] = 1;
    }
    exact += static_cast<double>(truth.report.points.size());
    regions += static_cast<double>(truth.regions);
    regions_found += static_cast<double>(std::count(hit.begin(), hit.end(), 1));
    auto kept = [&](const std::optional<double>& d) {
      return std::clamp(d.value_or(pair.tolerance), 0.0, pair.tolerance);
    };
    const double error = std::fabs(kept(reports[k].least) - kept(truth.report.least)) / pair.radius;
    error_sum += error;
    quality.error_max = std::max(quality.error_max.value_or(0.0), error);
    if (has_depth && truth.report.least.value_or(0.0) < 0.0) {
      const double off =
          std::fabs(reports[k].least.value_or(pair.tolerance) - *truth.report.least) / pair.radius;
      quality.depth_error = std::max(quality.depth_error.value_or(0.0), off);
    }
  }
  if (exact > 0.0) quality.recall = found / exact;
  if (regions > 0.0) quality.regions = regions_found / regions;
  if (!truths.empty()) quality.error_mean = error_sum / static_cast<double>(truths.size());
  return quality;
}

LevelTiming measure_levels(const BenchPair& pair, const std::vector<Pose>& path,
                           const Resolution& resolution, int runs,
                           const std::vector<std::size_t>& checked,
                           const std::vector<Truth>& truths) {
  LevelTiming out;
  ContactFront front;
  reserve_front(front, pair.object, pair.scene);
  if (resolution.carry > 0.0) reserve_carried(front);
  ContactSet set;
  set.contacts.reserve(kRoom);
  const ContactQuery query{.tolerance = pair.tolerance, .resolution = resolution};
  std::vector<double> best(path.size(), std::numeric_limits<double>::infinity());
  std::vector<char> is_meeting(path.size(), 0);
  std::vector<Report> reports;
  const double share = 1.0 / static_cast<double>(path.size() - 1);
  for (int run = 0; run < runs; ++run) {
    clear_front(front);
    for (std::size_t i = 0; i < path.size(); ++i) {
      clear(set);
      const double start = thread_cpu();
      query_contacts({pair.object, path[i]}, {pair.scene}, query, front, set);
      best[i] = std::min(best[i], thread_cpu() - start);
      if (run > 0) continue;
      is_meeting[i] = least_distance(set) <= 0.0 ? 1 : 0;
      if (reports.size() < checked.size() && checked[reports.size()] == i)
        reports.push_back(report_of(set));
      if (i == 0) continue;
      out.method.contacts += share * static_cast<double>(set.contacts.size());
      out.front += share * static_cast<double>(set.stats.front);
      out.tests += share * static_cast<double>(set.stats.tests);
      out.dropped += set.dropped;
      out.unrefined += set.stats.unrefined;
    }
  }
  out.cold_us = 1e6 * best.front();
  std::vector<double> apart, meeting;
  for (std::size_t i = 1; i < path.size(); ++i)
    (is_meeting[i] != 0 ? meeting : apart).push_back(best[i]);
  out.apart_us = 1e6 * sample_quantile(apart, 0.5);
  out.meeting_us = 1e6 * sample_quantile(meeting, 0.5);
  best.erase(best.begin());
  out.method.us = figure_of(best, 1e6);
  out.method.poses = static_cast<std::int64_t>(best.size());
  out.method.quality = compare(pair, truths, reports);
  return out;
}

MethodTiming measure_shell(const BenchPair& pair, const std::vector<Pose>& path,
                           const std::vector<std::size_t>& checked,
                           const std::vector<Truth>& truths) {
  std::vector<ShellContact> contacts;
  MethodTiming out = time_poses(
      pair, path, std::numeric_limits<double>::infinity(), checked, truths, true,
      [&](const Pose& pose) {
        query_shells(pair.object_shell, pose, pair.scene_shell, Pose{}, pair.tolerance, contacts);
        return contacts.size();
      },
      [&] { return report_of_depths(contacts); });
  out.name = "point shell, tree, both ways";
  return out;
}

std::optional<MethodTiming> measure_bullet(const BenchPair& pair, const std::vector<Pose>& path,
                                           double seconds, const std::vector<std::size_t>& checked,
                                           const std::vector<Truth>& truths) {
  if (!has_bullet()) return std::nullopt;
  const BulletPairPtr bullet =
      make_bullet_pair(pair.object_mesh, pair.scene_mesh, pair.tolerance, pair.radius);
  std::vector<BulletContact> contacts;
  MethodTiming out = time_poses(
      pair, path, seconds, checked, truths, true,
      [&](const Pose& pose) {
        query_bullet(*bullet, pose, contacts);
        return contacts.size();
      },
      [&] { return report_of_depths(contacts); });
  out.name = "Bullet 3.24 GImpact, all contacts within d";
  return out;
}

std::optional<MethodTiming> measure_fcl(const BenchPair& pair, const std::vector<Pose>& path,
                                        double seconds, const std::vector<std::size_t>& checked,
                                        const std::vector<Truth>& truths) {
  if (!has_fcl()) return std::nullopt;
  const FclPairPtr fcl = make_fcl_pair(pair.object_mesh, pair.scene_mesh);
  FclDistance found;
  MethodTiming out = time_poses(
      pair, path, seconds, checked, truths, false,
      [&](const Pose& pose) {
        found = fcl_distance(*fcl, pose);
        return std::size_t{1};
      },
      [&] {
        Report report;
        report.points = {0.5 * (found.point_object + found.point_scene)};
        report.least = std::max(0.0, found.distance);
        return report;
      });
  out.name = "FCL 0.7 distance (one closest pair)";
  return out;
}

}  // namespace thigma::bench
