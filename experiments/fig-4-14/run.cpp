// Fig. 4.14: a ridged block is dragged over a gear, along the ridges and across them, in contact.

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/statistics.h"
#include "experiments/common/textured_session.h"

#include "thigma/math/elementary.h"
#include "thigma/models/textured_model.h"
#include "thigma/models/textured_parts.h"

namespace thigma::experiments {
namespace fig_4_14 {
namespace {

constexpr double kGap = 0.0015, kPress = 0.003;          // of the scene; beyond the rest [m]
constexpr double kDown = 1.0, kAlong = 1.0;              // [s]: down, then along the ridges
constexpr double kRest = 0.2;                            // before each way [s]
constexpr double kWayAlong = 0.010, kWayAcross = 0.035;  // [m]; ridges are 10 mm apart

/// Ridges of the block and teeth of the gear.
struct Ridges {
  const char* name;
  models::RidgeProfile profile;
};

/// A way to drag the block.
struct Drag {
  double press = kPress;  // of the target beyond the rest [m]
  double across = 3.0;    // time of the way across [s]
  double seconds() const { return kDown + kAlong + across + 2.0 * kRest; }
};

Ridges flat_ridges(const char* name, double flank) {
  return {name, [flank](double turns) { return models::flat_ridge(turns, flank); }};
}

Ridges sine_ridges() {
  return {"sines", [](double turns) { return sine(2.0 * kPi * turns); }};
}

/// As the text has its axes: x along the ridges, y across them.
Pose pose_at(const Drag& drag, double t) {
  const auto share = [](double at, double time) { return std::clamp(at / time, 0.0, 1.0); };
  const double down = share(t, kDown);
  Pose pose;
  pose.position.z() = -(kGap + drag.press) * down * down * (3.0 - 2.0 * down);
  pose.position.x() = kWayAlong * share(t - kDown - kRest, kAlong);
  pose.position.y() = kWayAcross * share(t - kDown - kAlong - 2.0 * kRest, drag.across);
  return pose;
}

struct Curves {
  std::vector<double> time;
  std::array<std::vector<double>, 3> place, force;  // along x, y, z
  std::size_t across = 0;                           // first index of the way across
  double faults = 0.0;
};

Curves drag_block(const Ridges& ridges, const Drag& drag, int texels) {
  const auto make = [&](const SceneObject& object) {
    if (object.textured_model->name != "gear")
      return models::make_block(ridges.profile, texels, ridges.name);
    const models::TexturedSheet gear = models::make_gear_sheet(ridges.profile);
    return make_texture(models::make_textured_sheets({&gear, 1}, texels), ridges.name);
  };
  const auto session = textured_session("block_on_gear", true, {}, make);
  const ScriptRun run =
      run_script(*session, drag.seconds(), [&](double t) { return pose_at(drag, t); });
  Curves c;
  for (const HapticSample& s : run.frames) {
    if (s.time < kDown + kRest) continue;
    if (s.time < kDown + kAlong + 2.0 * kRest) ++c.across;
    c.time.push_back(s.time);
    for (std::size_t k = 0; k < 3; ++k) {
      c.place[k].push_back(s.body.position[static_cast<int>(k)]);
      c.force[k].push_back(s.contact.force[static_cast<int>(k)]);
    }
  }
  c.faults = static_cast<double>(run.summary.safety_events.size());
  return c;
}

struct Measured {
  double stairs = 0.0;  // share of the time across in which the height rests
  // the same, above the middle of its range: on the ridges, not between them
  double on_tops = 0.0;
  double ridge_free = 0.0;  // force along the ridges over the normal force, root mean squares
  double correlated = 0.0;  // of the force across with the slope being climbed
  double height = 0.0;      // range across [m]
};

/// Share of the time across in which the block moves up and down by less than a fifth of its mean
/// speed of doing so, where it is above a height.
double resting(std::span<const double> z, double above) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < z.size(); ++i) steps.push_back(std::fabs(z[i] - z[i - 1]));
  const double limit = 0.2 * mean(steps);
  int slow = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) slow += steps[i] < limit && z[i] > above;
  return slow / static_cast<double>(steps.size());
}

/// Correlation of the sideways force with the slope the block is on: with the change of its height
/// over 20 ms. A block that stands, at less than a tenth of its mean speed, does not tell a slope.
double correlated_with_climb(std::span<const double> y, std::span<const double> z,
                             std::span<const double> force) {
  constexpr std::size_t kSpan = 10;  // frames
  const double least = 0.1 * 2.0 * kSpan * kWayAcross / static_cast<double>(z.size());
  std::vector<double> climb, push;
  for (std::size_t i = kSpan; i + kSpan < z.size(); ++i) {
    const double way = y[i + kSpan] - y[i - kSpan];
    if (std::fabs(way) < least) continue;
    climb.push_back((z[i + kSpan] - z[i - kSpan]) / way);
    push.push_back(-force[i]);
  }
  return correlation(climb, push);
}

Measured measure(const Curves& c) {
  const std::span<const double> y = std::span(c.place[1]).subspan(c.across),
                                z = std::span(c.place[2]).subspan(c.across),
                                force = std::span(c.force[1]).subspan(c.across);
  const auto [low, high] = std::minmax_element(z.begin(), z.end());
  return {.stairs = resting(z, *low - 1.0),
          .on_tops = resting(z, 0.5 * (*low + *high)),
          .ridge_free = root_mean_square(c.force[0]) / root_mean_square(c.force[2]),
          .correlated = correlated_with_climb(y, z, force),
          .height = *high - *low};
}

void show(const Curves& c, Outcome& outcome) {
  outcome.tables = {{.name = "data",
                     .columns = {"time [s]", "x [m]", "y [m]", "z [m]", "force x [N]",
                                 "force y [N]", "force z [N]"}}};
  const std::array<const char*, 3> names = {"x, along the ridges", "y, across", "z"};
  plot::Panel place{.title = "Position", .x = {.label = "time [s]"}, .y = {.label = "[mm]"}};
  plot::Panel height{.title = "Height",
                     .x = {.label = "time [s]"},
                     .y = {.label = "z [mm]"},
                     .series = {{.color = 2}}};
  plot::Panel force{.title = "Contact force", .x = {.label = "time [s]"}, .y = {.label = "[N]"}};
  for (const char* name : names) {
    place.series.push_back({.label = name});
    force.series.push_back({.label = name});
  }
  for (std::size_t i = 0; i < c.time.size(); i += 5) {
    add_row(outcome.tables[0], {c.time[i], c.place[0][i], c.place[1][i], c.place[2][i],
                                c.force[0][i], c.force[1][i], c.force[2][i]});
    for (std::size_t k = 0; k < 3; ++k) {
      place.series[k].x.push_back(c.time[i]);
      place.series[k].y.push_back(1e3 * (c.place[k][i] - c.place[k][0]));
      force.series[k].x.push_back(c.time[i]);
      force.series[k].y.push_back(c.force[k][i]);
    }
    height.series[0].x.push_back(c.time[i]);
    height.series[0].y.push_back(place.series[2].y.back());
  }
  outcome.figure = {.title = "A block dragged over a gear (Fig. 4.14)",
                    .panels = {place, height, force}};
}

/// Other ridges and other presses: what makes the stairs.
double sweep(const Context& context, int texels, const Drag& drag, Outcome& outcome) {
  outcome.tables.push_back({.name = "sweep",
                            .columns = {"ridges", "half flank / pitch", "press [m]", "stairs",
                                        "on tops", "ridge-free", "correlated", "height [m]"}});
  struct Case {
    Ridges ridges;
    double flank;
  };
  const std::vector<Case> cases = {{sine_ridges(), std::nan("")},
                                   {flat_ridges("flat tops", 0.1875), 0.1875},
                                   {flat_ridges("flat tops", 0.125), 0.125},
                                   {flat_ridges("flat tops", 0.0625), 0.0625}};
  double round = std::nan("");
  for (std::size_t i = 0; i < (context.quick ? 1 : cases.size()); ++i) {
    for (const double press :
         context.quick ? std::vector{kPress} : std::vector{0.0015, kPress, 0.0045}) {
      tell(context, std::string("sweep: ") + cases[i].ridges.name);
      const Measured m = measure(drag_block(cases[i].ridges, {press, drag.across}, texels));
      add_row(outcome.tables.back(), {std::string(cases[i].ridges.name), cases[i].flank, press,
                                      m.stairs, m.on_tops, m.ridge_free, m.correlated, m.height});
      if (i == 0 && press == kPress) round = m.on_tops;
    }
  }
  return round;
}

}  // namespace
}  // namespace fig_4_14

Outcome run_fig_4_14(const Context& context) {
  using namespace fig_4_14;
  const Drag drag{.across = context.quick ? 2.0 : 3.0};
  const int texels = context.quick ? 512 : 1024;
  const Curves c = drag_block(flat_ridges("flat tops", models::kRidgeFlank), drag, texels);
  const Measured m = measure(c);
  Outcome outcome;
  show(c, outcome);
  const double round = sweep(context, texels, drag, outcome);
  outcome.claims = {
      at_most("ridge-free", "force along the ridges over the normal force, root mean squares",
              m.ridge_free, 0.05),
      at_least("stairs", "share of the time across in which the height rests", m.stairs, 0.2),
      at_least("correlated", "correlation of the force across with the slope the block climbs",
               m.correlated, 0.5),
      at_most("round",
              "share of the time in which it rests on tops with sine ridges on both, over that "
              "with flat tops",
              round / m.on_tops, 0.5),
      stated("on-tops", "share of the time across in which it rests on tops", m.on_tops),
      stated("height", "range of the height across", m.height, "m"),
      stated("normal", "mean normal force", mean(c.force[2]), "N"),
      at_most("faults", "safety events", c.faults, 0.0)};
  return outcome;
}

}  // namespace thigma::experiments
