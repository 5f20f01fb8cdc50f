// Table 3.3, without people: an ellipsoid slides over the dimpled ball at thresholds from 0.05 % to 20 %; how much of
// the force's modulation by the dimples is left.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/contact_profile.h"
#include "experiments/common/statistics.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace {

constexpr double kDifference = 0.07;  // just-noticeable difference of force, published
constexpr double kSpeed = 0.04;       // of the ellipsoid over the ball [m/s]
constexpr double kPitch = 0.0041;     // between dimples: 392 of them on the ball [m]
constexpr double kThresholds[] = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.2};

/// Which side of the ellipsoid (semi-axes 10, 6, 4 mm) is down.
struct Pass {
  const char* name;
  Vec3 down;     // axis of the ellipsoid towards the ball
  double reach;  // its semi-axis there [m]
};

const Pass kPasses[] = {
    {"tip", Vec3::UnitX(), 0.010}, {"side", Vec3::UnitY(), 0.006}, {"flat", Vec3::UnitZ(), 0.004}};

/// Around the ball at constant height: the ellipsoid's nearest point runs on the sphere the dimples are in.
Path slide_path(const Pass& pass, double ball_radius, double seconds) {
  Path path;
  const Vec3 axis = Vec3(0.2, -0.5, 1.0).normalized();  // no symmetry of the dimples' lattice
  const Vec3 first = axis.cross(Vec3::UnitX()).normalized();
  for (int i = 0; i * path.step < seconds; ++i) {
    const Quat around = rotation_from_vector(i * path.step * kSpeed / ball_radius * axis);
    const Vec3 out = around * first;
    Pose pose;
    pose.orientation = around * Quat::FromTwoVectors(pass.down, -first);
    pose.orientation.normalize();
    pose.position = (ball_radius + pass.reach) * out;
    path.poses.push_back(pose);
  }
  return path;
}

double modulation(const Profile& profile, double step) {
  const double frequency = kSpeed / kPitch;
  return band_level(profile.force_size, step, 0.5 * frequency, 2.0 * frequency);
}

/// How the query reads the support area, by name.
struct Reading {
  const char* name;
  SupportReading reading;
  SupportArea area;
};

constexpr Reading kReadings[] = {
    {"flood, larger D", SupportReading::flood, SupportArea::larger},
    {"flood, smaller D", SupportReading::flood, SupportArea::smaller},
    {"one-ring, larger D", SupportReading::one_ring, SupportArea::larger}};

/// Modulation of each pass at each threshold, exact first.
struct Curve {
  std::vector<double> total;  // root mean square over the passes
  std::vector<std::vector<double>> by_pass;
};

Curve measure(const Context& context, const Pair& pair, const std::vector<Path>& paths,
              const PenaltyParams& gains, const Reading& reading) {
  Curve curve;
  std::vector<double> thresholds = {0.0};
  thresholds.insert(thresholds.end(), std::begin(kThresholds), std::end(kThresholds));
  for (const double s0 : thresholds) {
    tell(context, std::string(reading.name) + ", s0 = " + std::to_string(100.0 * s0) + " %");
    // The query's threshold is a share of the smaller radius, the ellipsoid's.
    Resolution resolution =
        as_in_text(s0 * pair.radius / std::min(pair.object->radius, pair.scene->radius));
    resolution.reading = reading.reading;
    resolution.area = reading.area;
    std::vector<double> levels;
    for (const Path& path : paths)
      levels.push_back(modulation(replay(pair, path, resolution, gains), path.step));
    curve.total.push_back(root_mean_square(levels));
    curve.by_pass.push_back(levels);
  }
  return curve;
}

/// Share of the exact modulation that is left, at each threshold.
std::vector<double> left_of(const Curve& curve) {
  std::vector<double> left;
  for (std::size_t i = 1; i < curve.total.size(); ++i)
    left.push_back(curve.total[i] / curve.total[0]);
  return left;
}

/// Threshold at which the difference first exceeds what is noticed, between those tried by its logarithm [%]; NaN: never.
double crossing(const std::vector<double>& left) {
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double now = std::fabs(left[i] - 1.0);
    if (!(now > kDifference)) continue;
    if (i == 0) return 100.0 * kThresholds[0];
    const double before = std::fabs(left[i - 1] - 1.0);
    const double share = (kDifference - before) / (now - before);
    return 100.0 * kThresholds[i - 1] * std::pow(kThresholds[i] / kThresholds[i - 1], share);
  }
  return std::nan("");
}

void add_curve(const Reading& reading, const Curve& curve, Outcome& outcome) {
  const std::vector<double> left = left_of(curve);
  plot::Series series{.label = reading.name, .mark = plot::Mark::line_and_points};
  for (std::size_t i = 0; i < curve.total.size(); ++i) {
    const double s0 = i == 0 ? 0.0 : kThresholds[i - 1];
    std::vector<Cell> row = {reading.name, s0, curve.total[i], curve.total[i] / curve.total[0]};
    for (const double level : curve.by_pass[i]) row.push_back(level);
    add_row(outcome.tables[0], row);
    if (i == 0) continue;
    series.x.push_back(100.0 * s0);
    series.y.push_back(left[i - 1]);
  }
  outcome.figure.panels[0].series.push_back(series);
}

std::vector<Claim> make_claims(const std::vector<double>& left) {
  double kept = 0.0, lost = 1.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (kThresholds[i] <= 0.01) kept = std::max(kept, std::fabs(left[i] - 1.0));
    if (kThresholds[i] >= 0.1) lost = std::min(lost, 1.0 - left[i]);
  }
  return {
      at_most(
          "kept",
          "largest change of the dimple-band force modulation at s0 <= 1 %: within one published "
          "just-noticeable difference (7 %); below it, which is not to say imperceptible",
          100.0 * kept, 100.0 * kDifference, "%"),
      at_least("lost", "smallest loss of modulation at s0 >= 10 %: more than that difference",
               100.0 * lost, 100.0 * kDifference, "%"),
      within("between",
             "threshold at which the change first exceeds it; the source's users: 2.5 to 5 %",
             crossing(left), 1.0, 10.0, "%")};
}

}  // namespace

Outcome run_table_3_3(const Context& context) {
  Pair pair;
  pair.name = "ellipsoid on golf ball";
  ClodHierarchy ellipsoid = build_exact_hierarchy(make_mesh(model_uri("ellipsoid", 2000)));
  // Without levels it has no support areas of its own: those of the ball decide (Eq. 3.7, the larger).
  ellipsoid.support.assign(ellipsoid.vertices.size(), {0.0, 0.0});
  pair.object = &ellipsoid;
  pair.scene =
      &levels_of(*context.assets, model_uri("golf_ball", context.quick ? 44'000 : 177'876));
  const double ball = pair.scene->radius;
  pair.radius = ball;  // what tolerance and thresholds are shares of here
  const PenaltyParams gains = direct_gains(pair);
  std::vector<Path> paths;
  for (const Pass& pass : kPasses)
    paths.push_back(slide_path(pass, ball, context.quick ? 1.0 : 3.0));

  Outcome outcome;
  outcome.tables = {{.columns = {"support area", "s0", "modulation [N]", "share of exact",
                                 "tip [N]", "side [N]", "flat [N]"}}};
  outcome.figure = {.title = "Dimples left in the force (Table 3.3)",
                    .note =
                        "ellipsoid without levels on the golf ball; force modulation in the dimple "
                        "band over the exact one",
                    .panels = {{.x = {.label = "s0 [% of the ball's radius]", .is_log = true},
                                .y = {.label = "modulation / exact"},
                                .guides = {{"1 - 7 %", 1.0 - kDifference},
                                           {"1 + 7 %", 1.0 + kDifference},
                                           {"source's users: 2.5 %", 2.5, true},
                                           {"5 %", 5.0, true}}}},
                    .panel_height = 380};
  for (const Reading& reading : kReadings) {
    const Curve curve = measure(context, pair, paths, gains, reading);
    add_curve(reading, curve, outcome);
    if (outcome.claims.empty()) outcome.claims = make_claims(left_of(curve));
  }
  return outcome;
}

}  // namespace thigma::experiments
