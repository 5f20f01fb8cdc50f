// Fig. 4.15: a striped block that lies in another is turned to and fro about the normal; it rises
// as soon as it turns.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/statistics.h"
#include "experiments/common/textured_session.h"

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace fig_4_15 {
namespace {

constexpr double kPress = 0.003;              // of the target beyond where the block rests [m]
constexpr double kGap = 0.0015;               // of the scene, above that [m]
constexpr double kTurn = 0.12, kRate = 0.25;  // amplitude and frequency of the turning [rad, Hz]
constexpr double kDown = 1.5;                 // [s]

Pose pose_at(double t) {
  const double down = std::clamp(t / kDown, 0.0, 1.0);
  Pose pose;
  pose.position.z() = -(kGap + kPress) * down * down * (3.0 - 2.0 * down);
  const double turning = std::max(t - kDown - 0.2, 0.0);
  pose.orientation =
      rotation_from_vector(Vec3(0.0, 0.0, kTurn * sine(2.0 * kPi * kRate * turning)));
  return pose;
}

double angle_of(const BodyState& state, const Quat& start) {
  const Quat by = state.orientation * start.conjugate();
  return 2.0 * arc_tangent2(by.z(), by.w());
}

struct Curves {
  std::vector<double> time, angle, size, rise, torque;
};

Curves collect(const ScriptRun& run, const Quat& start) {
  Curves c;
  for (const HapticSample& s : run.frames) {
    if (s.time < kDown + 0.2) continue;
    c.time.push_back(s.time);
    c.angle.push_back(angle_of(s.body, start));
    c.size.push_back(std::fabs(c.angle.back()));
    c.rise.push_back(s.body.position.z());
    c.torque.push_back(s.contact.torque.z());
  }
  return c;
}

/// Share of the frames turned by more than a degree in which the contact torque turns back.
double opposing(const Curves& c) {
  constexpr double kDegree = kPi / 180.0;
  std::size_t turned = 0, back = 0;
  for (std::size_t i = 0; i < c.angle.size(); ++i) {
    if (c.size[i] < kDegree) continue;
    ++turned;
    back += c.angle[i] * c.torque[i] < 0.0;
  }
  return static_cast<double>(back) / static_cast<double>(turned);
}

}  // namespace
}  // namespace fig_4_15

Outcome run_fig_4_15(const Context& context) {
  using namespace fig_4_15;
  const double seconds = context.quick ? 6.0 : 12.0;
  const auto session = textured_session("blocks", true, [&](SceneDescription& scene) {
    for (SceneObject* o : {&scene.object, &scene.statics[0]})
      o->textured_model->texels = context.quick ? 512 : 1024;
  });
  const ScriptRun run = run_script(*session, seconds, pose_at);
  const Curves c = collect(run, session->config.world_from_body.orientation);
  Outcome outcome;
  outcome.tables = {
      {.name = "data",
       .columns = {"time [s]", "angle [rad]", "z [m]", "contact torque about z [N m]"}}};
  plot::Panel turn{.title = "Turned about n",
                   .x = {.label = "time [s]"},
                   .y = {.label = "[degrees]"},
                   .series = {{}}};
  plot::Panel rise{
      .title = "Risen along n", .x = {.label = "time [s]"}, .y = {.label = "[mm]"}, .series = {{}}};
  for (std::size_t i = 0; i < c.time.size(); i += 5) {
    add_row(outcome.tables[0], {c.time[i], c.angle[i], c.rise[i], c.torque[i]});
    turn.series[0].x.push_back(c.time[i]);
    turn.series[0].y.push_back(180.0 / kPi * c.angle[i]);
    rise.series[0].x.push_back(c.time[i]);
    rise.series[0].y.push_back(1e3 * (c.rise[i] - c.rise[0]));
  }
  outcome.figure = {.title = "Striped blocks (Fig. 4.15)", .panels = {turn, rise}};
  const auto [low, high] = std::minmax_element(c.rise.begin(), c.rise.end());
  outcome.claims = {
      at_least("rises", "rank correlation of the height along n with the angle turned",
               rank_correlation(c.size, c.rise), 0.8),
      at_least("opposes", "share of frames turned by more than a degree whose torque turns back",
               opposing(c), 0.95),
      stated("height", "difference of height", *high - *low, "m"),
      stated("angle", "largest angle of the block", *std::max_element(c.size.begin(), c.size.end()),
             "rad"),
      stated("faults", "safety events", static_cast<double>(run.summary.safety_events.size()))};
  return outcome;
}

}  // namespace thigma::experiments
