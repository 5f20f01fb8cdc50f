// Fig. 4.14: a striped block is dragged over ridges, along them, across them and up, in contact.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/statistics.h"
#include "experiments/common/textured_session.h"

namespace thigma::experiments {
namespace fig_4_14 {
namespace {

constexpr double kPress = 0.003, kGap = 0.0015;          // as in fig-4-15 [m]
constexpr double kDown = 1.0, kAlong = 1.0;              // [s]: down, then along the ridges
constexpr double kWayAlong = 0.010, kWayAcross = 0.035;  // [m]; ridges are 10 mm apart

Pose pose_at(double t, double across) {
  const auto share = [](double at, double time) { return std::clamp(at / time, 0.0, 1.0); };
  const double down = share(t, kDown);
  Pose pose;
  pose.position.z() = -(kGap + kPress) * down * down * (3.0 - 2.0 * down);
  pose.position.y() = kWayAlong * share(t - kDown - 0.2, kAlong);
  pose.position.x() = kWayAcross * share(t - kDown - 0.4 - kAlong, across);
  return pose;
}

struct Curves {
  std::vector<double> time, x, y, z, force_x, force_y, force_z;
};

Curves collect(const ScriptRun& run, double begin) {
  Curves c;
  for (const HapticSample& s : run.frames) {
    if (s.time < begin) continue;
    c.time.push_back(s.time);
    c.x.push_back(s.body.position.x());
    c.y.push_back(s.body.position.y());
    c.z.push_back(s.body.position.z());
    c.force_x.push_back(s.contact.force.x());
    c.force_y.push_back(s.contact.force.y());
    c.force_z.push_back(s.contact.force.z());
  }
  return c;
}

/// Share of the time across in which the block's height is within a tenth of the ridge height of a local rest: it
/// moves up and down by less than a fifth of its mean speed of doing so.
double resting(const Curves& c, std::size_t begin) {
  double way = 0.0;
  for (std::size_t i = begin + 1; i < c.z.size(); ++i) way += std::fabs(c.z[i] - c.z[i - 1]);
  const double mean_step = way / static_cast<double>(c.z.size() - begin - 1);
  std::size_t slow = 0;
  for (std::size_t i = begin + 1; i < c.z.size(); ++i)
    slow += std::fabs(c.z[i] - c.z[i - 1]) < 0.2 * mean_step;
  return static_cast<double>(slow) / static_cast<double>(c.z.size() - begin - 1);
}

}  // namespace
}  // namespace fig_4_14

Outcome run_fig_4_14(const Context& context) {
  using namespace fig_4_14;
  const double across = context.quick ? 2.0 : 3.0;
  const double seconds = kDown + 0.4 + kAlong + across;
  const auto session = textured_session("blocks", true, [&](scenes::SceneDescription& scene) {
    for (scenes::SceneObject* o : {&scene.object, &scene.statics[0]})
      o->textured_model->texels = context.quick ? 512 : 1024;
  });
  const ScriptRun run = run_script(*session, seconds, [&](double t) { return pose_at(t, across); });
  const double begin = kDown + 0.2;
  const Curves c = collect(run, begin);
  const auto first_across = static_cast<std::size_t>((kAlong + 0.2) / 1e-3);
  const auto part = [&](const std::vector<double>& v, std::size_t from, std::size_t to) {
    return std::vector<double>(v.begin() + static_cast<std::ptrdiff_t>(from),
                               v.begin() + static_cast<std::ptrdiff_t>(std::min(to, v.size())));
  };
  Outcome outcome;
  outcome.tables = {{.name = "data",
                     .columns = {"time [s]", "x [m]", "y [m]", "z [m]", "force x [N]",
                                 "force y [N]", "force z [N]"}}};
  plot::Panel place{.title = "Position",
                    .x = {.label = "time [s]"},
                    .y = {.label = "[mm]"},
                    .series = {{.label = "x, across"}, {.label = "y, along"}, {.label = "z"}}};
  plot::Panel force{.title = "Contact force",
                    .x = {.label = "time [s]"},
                    .y = {.label = "[N]"},
                    .series = {{.label = "x, across"}, {.label = "y, along"}, {.label = "z"}}};
  const std::vector<double>* places[] = {&c.x, &c.y, &c.z};
  const std::vector<double>* forces[] = {&c.force_x, &c.force_y, &c.force_z};
  for (std::size_t i = 0; i < c.time.size(); i += 5) {
    add_row(outcome.tables[0],
            {c.time[i], c.x[i], c.y[i], c.z[i], c.force_x[i], c.force_y[i], c.force_z[i]});
    for (std::size_t k = 0; k < 3; ++k) {
      place.series[k].x.push_back(c.time[i]);
      place.series[k].y.push_back(1e3 * ((*places[k])[i] - (*places[k])[0]));
      force.series[k].x.push_back(c.time[i]);
      force.series[k].y.push_back((*forces[k])[i]);
    }
  }
  outcome.figure = {.title = "A block dragged over ridges (Fig. 4.14)", .panels = {place, force}};
  const std::size_t end = c.time.size();
  // The sideways force goes with the slope the block is on: with the change of its height.
  std::vector<double> climb, push;
  for (std::size_t i = first_across + 10; i + 10 < end; ++i) {
    const double way = c.x[i + 10] - c.x[i - 10];
    if (std::fabs(way) < 1e-6) continue;
    climb.push_back((c.z[i + 10] - c.z[i - 10]) / way);
    push.push_back(-c.force_x[i]);
  }
  outcome.claims = {
      at_most("ridge-free", "force along the ridges over the normal force, root mean squares",
              root_mean_square(part(c.force_y, 0, end)) / root_mean_square(part(c.force_z, 0, end)),
              0.05),
      known_not_to(
          at_least("stairs", "share of the time across in which the height rests",
               resting(c, first_across), 0.2),
          {"a block's sine ridges are round: it turns at the crests and in the grooves but does not rest there as on the "
           "gear's; the share that counts as staircase is ours",
           "data.csv", 0.05}),
      at_least("correlated", "correlation of the force across with the slope the block climbs",
               correlation(climb, push), 0.5),
      stated("normal", "mean normal force", mean(c.force_z), "N"),
      stated("faults", "safety events", static_cast<double>(run.summary.safety_events.size()))};
  return outcome;
}

}  // namespace thigma::experiments
