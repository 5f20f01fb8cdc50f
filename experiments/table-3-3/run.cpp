// Table 3.3, without people: an ellipsoid slides over the dimpled ball at thresholds from 0.05 % to
// 20 %; how much of the force's modulation by the dimples is left.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/contact_profile.h"
#include "experiments/common/statistics.h"

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace table_3_3 {
namespace {

constexpr double kDifference = 0.07;  // just-noticeable difference of force, published
constexpr double kSpeed = 0.04;       // of the ellipsoid over the ball [m/s]
constexpr double kPitch = 0.0041;     // between dimples: 392 of them on the ball [m]
constexpr double kTolerance = 0.003;  // d, of the ball's radius: a quarter of a dimple's depth
// how far the ellipsoid is pressed into the ball, of its radius
constexpr double kPress = 0.002;
constexpr double kThresholds[] = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.2};

/// Which side of the ellipsoid (semi-axes 10, 6, 4 mm) is down.
struct Pass {
  const char* name;
  Vec3 down;     // axis of the ellipsoid towards the ball
  double reach;  // its semi-axis there [m]
};

const Pass kPasses[] = {
    {"tip", Vec3::UnitX(), 0.010}, {"side", Vec3::UnitY(), 0.006}, {"flat", Vec3::UnitZ(), 0.004}};

/// Around the ball at constant height: the ellipsoid's nearest point runs a little below the sphere
/// the dimples are in.
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
    pose.position = ((1.0 - kPress) * ball_radius + pass.reach) * out;
    path.poses.push_back(pose);
  }
  return path;
}

/// How the query reads the support area, by name.
struct Reading {
  const char* name;
  SupportReading reading;
  double tolerance;  // of the areas, over the ball's radius
};

// What ships comes first: it is the one that is judged.
constexpr Reading kReadings[] = {{"flood within 0.4 %", SupportReading::flood, 0.004},
                                 {"flood within 0.1 %", SupportReading::flood, 0.001},
                                 {"flood within 1 %", SupportReading::flood, 0.01},
                                 {"one-ring", SupportReading::one_ring, 0.004}};

/// What is left of the dimples at one threshold.
struct Left {
  std::vector<double> levels;  // modulation of each pass, from whatever [N]
  double modulation = 0.0;     // root mean square of them [N]
  double share = 0.0;          // of the exact one that is in it
};

/// Frequencies within an octave of dimples per second.
constexpr double kLow = 0.5 * kSpeed / kPitch, kHigh = 2.0 * kSpeed / kPitch;

Left compare_passes(const std::vector<Profile>& passes, const std::vector<Profile>& exact,
                    double step) {
  Left left;
  double common = 0.0, power = 0.0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    left.levels.push_back(band_level(passes[i].force_size, step, kLow, kHigh));
    const double of_exact = band_level(exact[i].force_size, step, kLow, kHigh);
    common += of_exact * of_exact *
              band_share(passes[i].force_size, exact[i].force_size, step, kLow, kHigh);
    power += of_exact * of_exact;
  }
  left.modulation = root_mean_square(left.levels);
  left.share = common / power;
  return left;
}

/// At each threshold, exact first.
std::vector<Left> measure(const Context& context, const Pair& pair, const std::vector<Path>& paths,
                          const Reading& reading) {
  const PenaltyParams gains = direct_gains(pair, kTolerance);
  std::vector<Profile> exact;
  for (const Path& path : paths) exact.push_back(replay(pair, path, as_in_text(0.0), gains));
  std::vector<Left> curve = {compare_passes(exact, exact, paths.front().step)};
  for (const double s0 : kThresholds) {
    tell(context, std::string(reading.name) + ", s0 = " + std::to_string(100.0 * s0) + " %");
    // The query's threshold is a share of the smaller radius, the ellipsoid's.
    Resolution resolution =
        as_in_text(s0 * pair.radius / std::min(pair.object->radius, pair.scene->radius));
    resolution.reading = reading.reading;
    std::vector<Profile> passes;
    for (const Path& path : paths) passes.push_back(replay(pair, path, resolution, gains));
    curve.push_back(compare_passes(passes, exact, paths.front().step));
  }
  return curve;
}

/// Share of the exact modulation that is left, at each threshold.
std::vector<double> shares_of(const std::vector<Left>& curve) {
  std::vector<double> left;
  for (std::size_t i = 1; i < curve.size(); ++i) left.push_back(curve[i].share);
  return left;
}

/// Threshold at which the difference first exceeds what is noticed, between those tried by its
/// logarithm [%]; NaN: never.
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

void add_curve(const Reading& reading, const std::vector<Left>& curve, Outcome& outcome) {
  plot::Series series{.label = reading.name, .mark = plot::Mark::line_and_points};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double s0 = i == 0 ? 0.0 : kThresholds[i - 1];
    std::vector<Cell> row = {reading.name, s0, curve[i].share, curve[i].modulation,
                             curve[i].modulation / curve[0].modulation};
    for (const double level : curve[i].levels) row.push_back(level);
    add_row(outcome.tables[0], row);
    if (i == 0) continue;
    series.x.push_back(100.0 * s0);
    series.y.push_back(curve[i].share);
  }
  outcome.figure.panels[0].series.push_back(series);
}

constexpr const char* kWhyNot =
    "facets of the first levels modulate the force in the dimples' band too: the share left is "
    "above 1, by a quarter at most, until it falls below near 1 %; with smaller areas of small "
    "models it never falls (data.csv)";

std::vector<Claim> make_claims(const std::vector<double>& left) {
  double kept = 0.0, lost = 1.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (kThresholds[i] <= 0.01) kept = std::max(kept, std::fabs(left[i] - 1.0));
    if (kThresholds[i] >= 0.1) lost = std::min(lost, 1.0 - left[i]);
  }
  return {known_not_to(
              at_most("kept",
                      "largest change of the dimples' force modulation at s0 <= 1 %: within one "
                      "published just-noticeable difference (7 %); below it, which is not to say "
                      "imperceptible",
                      100.0 * kept, 100.0 * kDifference, "%"),
              {kWhyNot, "data.csv", 60.0}),
          at_least("lost", "smallest loss of modulation at s0 >= 10 %: more than that difference",
                   100.0 * lost, 100.0 * kDifference, "%"),
          known_not_to(within("between",
                              "threshold at which the change first exceeds it; the source's users: "
                              "2.5 to 5 %",
                              crossing(left), 1.0, 10.0, "%"),
                       {kWhyNot, "data.csv", 20.0, 0.05})};
}

}  // namespace
}  // namespace table_3_3

Outcome run_table_3_3(const Context& context) {
  using namespace table_3_3;
  const std::string ball_uri = model_uri("golf_ball", context.quick ? 44'000 : 177'876);
  ClodHierarchy ellipsoid = build_exact_hierarchy(make_mesh(model_uri("ellipsoid", 2000)));
  // Without levels it has no support areas of its own: those of the ball decide (Eq. 3.7, the
  // larger).
  ellipsoid.support.assign(ellipsoid.vertices.size(), {0.0, 0.0});
  Pair pair;
  pair.name = "ellipsoid on golf ball";
  pair.object = &ellipsoid;
  pair.scene = &levels_of(*context.assets, ball_uri);
  const double ball = pair.scene->radius;
  pair.radius = ball;  // what tolerance and thresholds are shares of here
  std::vector<Path> paths;
  for (const Pass& pass : kPasses)
    paths.push_back(slide_path(pass, ball, context.quick ? 1.0 : 3.0));

  Outcome outcome;
  outcome.tables = {{.columns = {"support area", "s0", "share of the exact modulation left",
                                 "modulation from whatever [N]", "the same over the exact one",
                                 "tip [N]", "side [N]", "flat [N]"}}};
  outcome.figure = {.title = "Dimples left in the force (Table 3.3)",
                    .note =
                        "ellipsoid without levels on the golf ball; share of the exact force's "
                        "modulation in the dimple band that is left, by support area",
                    .panels = {{.x = {.label = "s0 [% of the ball's radius]", .is_log = true},
                                .y = {.label = "share left"},
                                .guides = {{"1 - 7 %", 1.0 - kDifference},
                                           {"1 + 7 %", 1.0 + kDifference},
                                           {"source's users: 2.5 %", 2.5, true},
                                           {"5 %", 5.0, true}}}},
                    .panel_height = 380};
  ClodHierarchy other_areas;
  for (const Reading& reading : kReadings) {
    Pair own = pair;
    ClodParams params;
    if (reading.tolerance != params.contact_tolerance) {
      params.contact_tolerance = reading.tolerance;
      params.threads = 2;
      other_areas = build_clod(make_mesh(ball_uri), params);
      own.scene = &other_areas;
    }
    const std::vector<Left> curve = measure(context, own, paths, reading);
    add_curve(reading, curve, outcome);
    if (outcome.claims.empty()) outcome.claims = make_claims(shares_of(curve));
  }
  return outcome;
}

}  // namespace thigma::experiments
