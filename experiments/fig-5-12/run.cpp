// Fig. 5.12: a probe led over a plate with sinusoidal ridges and over the flat plate below them,
// out slowly, back faster.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/statistics.h"
#include "experiments/common/textured_session.h"

#include "thigma/math/elementary.h"

namespace thigma::experiments {
namespace fig_5_12 {
namespace {

constexpr double kWave = 0.035;             // of the ridges of scenes/plate.toml [m]
constexpr double kPress = 0.002;            // below the touch of the flat plate [m]
constexpr double kWay = 0.245;              // seven ridges [m]
constexpr double kDown = 1.2, kRest = 0.3;  // [s]
constexpr int kContactEvery = 3;  // haptic frames: 333 Hz; the text says slightly above 400

struct Stroke {
  double begin = 0.0, end = 0.0, speed = 0.0;  // [s, m/s]
};

struct Motion512 {
  Stroke slow, fast;
  double seconds = 0.0, height = 0.0;  // of the way down [m]
};

Motion512 plan(double gap) {
  Motion512 m;
  m.slow = {kDown + kRest, kDown + kRest + 3.0, kWay / 3.0};
  m.fast = {m.slow.end + kRest, m.slow.end + kRest + 1.72, kWay / 1.72};
  m.seconds = m.fast.end + kRest;
  m.height = gap + kPress;
  return m;
}

Pose pose_at(const Motion512& m, double t) {
  const auto share = [&](const Stroke& s) {
    return std::clamp((t - s.begin) / (s.end - s.begin), 0.0, 1.0);
  };
  const double down = std::clamp(t / kDown, 0.0, 1.0);
  Pose pose;
  pose.position.z() = -m.height * down * down * (3.0 - 2.0 * down);
  pose.position.x() = kWay * (share(m.slow) - share(m.fast));
  return pose;
}

/// One measured stroke of one run.
struct Measured {
  double mean = 0.0, deviation = 0.0, peak = 0.0;  // of the feedback force [N; Hz]
};

/// Power of a signal at a frequency, by a Hann window.
double power_at(const std::vector<double>& x, double middle, double step, double f) {
  double c = 0.0, s = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double window =
        1.0 - cosine(2.0 * kPi * static_cast<double>(i) / static_cast<double>(x.size()));
    const SinCos w = sin_cos(2.0 * kPi * f * step * static_cast<double>(i));
    c += window * (x[i] - middle) * w.cos;
    s += window * (x[i] - middle) * w.sin;
  }
  return c * c + s * s;
}

/// The frequency at which a signal has most power: from one period in the whole of it, below which
/// a window sees only its mean, to a tenth of the sampling rate.
double peak_frequency(const std::vector<double>& x, double step) {
  const double middle = mean(x);
  const double line = 1.0 / (step * static_cast<double>(x.size()));  // of a discrete transform [Hz]
  const auto highest = [&](double low, double high, double by) {
    double best = low, most = -1.0;
    for (double f = low; f <= high; f += by) {
      const double power = power_at(x, middle, step, f);
      if (power > most) {
        most = power;
        best = f;
      }
    }
    return best;
  };
  const double near = highest(line, 0.1 / step, 0.25 * line);
  return highest(std::max(line, near - 0.5 * line), near + 0.5 * line, 0.01 * line);
}

Measured measure(const ScriptRun& run, const Stroke& stroke) {
  std::vector<double> force;
  for (const HapticSample& s : run.frames)
    if (s.time >= stroke.begin + 0.1 && s.time < stroke.end) force.push_back(s.feedback.force.z());
  return {mean(force), standard_deviation(force), peak_frequency(force, 1e-3)};
}

/// Share of the feedback force's variation above a frequency, to its mean, while the probe rests in
/// contact.
double noise(const ScriptRun& run, double begin, double end) {
  std::vector<double> force;
  for (const HapticSample& s : run.frames)
    if (s.time >= begin && s.time < end) force.push_back(s.feedback.force.z());
  return band_level(force, 1e-3, 300.0, 499.0) / std::fabs(mean(force));
}

double depth_max(const ScriptRun& run) {
  double most = 0.0;
  for (const HapticSample& s : run.frames) most = std::max(most, s.penetration);
  return most;
}

void add_frames(const char* plate, const ScriptRun& run, Outcome& outcome, plot::Panel& depth,
                plot::Panel& force) {
  plot::Series depths{.label = plate}, forces{.label = plate};
  for (std::size_t i = 0; i < run.frames.size(); i += 5) {
    const HapticSample& s = run.frames[i];
    add_row(outcome.tables[0],
            {std::string(plate), s.time, s.body.position.x(), s.body.position.z(), s.penetration,
             s.feedback.force.x(), s.feedback.force.z()});
    depths.x.push_back(s.time);
    depths.y.push_back(s.penetration > 0.0 ? 1e3 * s.penetration : 0.0);
    forces.x.push_back(s.time);
    forces.y.push_back(s.feedback.force.norm());
  }
  depth.series.push_back(depths);
  force.series.push_back(forces);
}

}  // namespace
}  // namespace fig_5_12

Outcome run_fig_5_12(const Context& context) {
  using namespace fig_5_12;
  const int texels = context.quick ? 512 : 1024;
  const auto make = [&](bool is_textured) {
    auto session = textured_session("plate", is_textured, [&](SceneDescription& scene) {
      scene.contact.stiffness = 2000.0;  // the text's
      scene.object.world_from_mesh.position.x() = -0.5 * kWay;
      scene.statics[0].textured_model->texels = texels;
    });
    session->config.contact_every = kContactEvery;
    return session;
  };
  const auto ridged = make(true), flat = make(false);
  // From the tip to the top of the flat plate.
  const double gap = ridged->scene.object.world_from_mesh.position.z() - 0.050 - 0.005;
  const Motion512 motion = plan(gap);
  const auto lead = [&](double t) { return pose_at(motion, t); };
  const ScriptRun on_ridges = run_script(*ridged, motion.seconds, lead);
  const ScriptRun on_flat = run_script(*flat, motion.seconds, lead);

  Outcome outcome;
  outcome.tables = {{.name = "data",
                     .columns = {"plate", "time [s]", "x [m]", "z [m]", "depth [m]",
                                 "feedback x [N]", "feedback z [N]"}}};
  plot::Panel depth{
      .title = "Penetration depth", .x = {.label = "time [s]"}, .y = {.label = "depth [mm]"}};
  plot::Panel force{
      .title = "Feedback force", .x = {.label = "time [s]"}, .y = {.label = "force [N]"}};
  add_frames("flat", on_flat, outcome, depth, force);
  add_frames("ridged", on_ridges, outcome, depth, force);
  outcome.figure = {.title = "Probe on a plate with ridges (Fig. 5.12)", .panels = {depth, force}};

  const Measured slow = measure(on_ridges, motion.slow), fast = measure(on_ridges, motion.fast);
  const Measured bare = measure(on_flat, motion.slow);
  const auto off = [](const Measured& m, const Stroke& s) {
    return std::fabs(m.peak * kWave / s.speed - 1.0);
  };
  outcome.claims = {
      at_most("frequency", "force peak off speed over wavelength, the worse of the two strokes",
              std::max(off(slow, motion.slow), off(fast, motion.fast)), 0.02),
      above("textured", "standard deviation of the force on ridges, the lesser of the two strokes",
            std::min(slow.deviation, fast.deviation), 0.3, "N"),
      below("flat", "the same on the flat plate", bare.deviation, 1e-3, "N"),
      at_most("stable",
              "force above 300 Hz at 333 contact frames a second over its mean, at rest on a ridge",
              noise(on_ridges, motion.slow.end + 0.05, motion.fast.begin), 0.02),
      stated("depth", "largest depth on ridges", depth_max(on_ridges), "m"),
      stated("faults", "safety events",
             static_cast<double>(on_ridges.summary.safety_events.size())),
      stated("mean", "mean force of the slow stroke", slow.mean, "N")};
  return outcome;
}

}  // namespace thigma::experiments
