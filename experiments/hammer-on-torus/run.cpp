// Sec. 4.5.2, 5.6.2: textured hammer on a textured torus, and the other textured scenes, led by a
// simulated hand at 5 kN/m, 10 g, five clusters. The text's own set-up was unstable on these.

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/common/statistics.h"
#include "experiments/common/texture_experiments.h"
#include "experiments/common/textured_session.h"
#include "experiments/hammer-on-torus/strokes.h"

#include "thigma/depth/depth_gradient.h"
#include "thigma/device/open_device.h"
#include "thigma/loop/contact_step.h"
#include "thigma/math/quantile.h"
#include "thigma/response/texture_contacts.h"
#include "thigma/scene/start_placement.h"

namespace thigma::experiments {
namespace hammer_on_torus {
namespace {

struct LedRun {
  std::vector<HapticSample> frames;
  SessionSummary summary;
  // of the depth over all texels, by the summed amplitudes; one a textured contact
  std::vector<double> missed;
};

std::unique_ptr<HapticDevice> open_hand(TexturedSession& session, std::uint64_t seed) {
  SessionConfig& config = session.config;
  const std::optional<Vec3>& approach = session.scene.device.approach;
  const Vec3 out = approach ? Vec3(-*approach) : Vec3::Zero();
  const StartPlacement start =
      find_start(config.contact, config.world_from_body, 0.0, approach ? &out : nullptr);
  config.world_from_body = start.world_from_body;
  const Workspace& workspace = config.haptic.workspace;
  DeviceContext hand;
  hand.approach =
      workspace.world_from_device.orientation.conjugate()._transformVector(start.approach);
  hand.clearance = start.clearance / workspace.motion_scale;
  hand.object_radius = session.object->hierarchy.radius / workspace.motion_scale;
  hand.seed = seed;
  return open_device("hand:", hand);
}

/// What the grid misses of the depth over all texels, along the motion.
std::vector<double> missed_depths(const TexturedSession& session,
                                  const std::vector<HapticSample>& frames, int stride) {
  ContactScratch scratch;
  reserve_contact_scratch(session.config.contact, scratch);
  const auto exact = make_branch_depth({});
  std::vector<double> missed;
  ContactSample sample;
  for (std::size_t i = 0; i < frames.size(); i += static_cast<std::size_t>(stride)) {
    contact_step(session.config.contact, {frames[i].body, frames[i].time, i + 1}, scratch, sample);
    const std::vector<DepthContact>& contacts = scratch.textures->contacts;
    std::vector<DepthSamples> all(contacts.size());
    exact->sample(contacts, {}, all);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const DepthSamples& grid = scratch.textures->samples[c];
      // Those that press: a force begins at the tolerance.
      if (!all[c].is_found || !grid.is_found ||
          !(all[c].depth[0] > -session.config.contact.tolerance))
        continue;
      const double amplitude =
          contacts[c].object.texture->amplitude + contacts[c].scene.texture->amplitude;
      missed.push_back(std::max(all[c].depth[0] - grid.depth[0], 0.0) / amplitude);
    }
  }
  return missed;
}

/// A scene led by a hand.
struct Lead {
  std::string scene = "hammer_on_torus";
  GradientKind gradient = GradientKind::smoothed_envelope;
  int resolution = 50;
  double stiffness = 5000.0;  // [N/m]
  // haptic frames from one contact model to the next, and until it is used
  int every = 1;
};

LedRun lead_scene(const Context& context, const Lead& lead, double seconds) {
  const auto session = textured_session(lead.scene, true, [&](SceneDescription& s) {
    s.contact.texture.gradient = lead.gradient;
    s.contact.texture.resolution = lead.resolution;
    s.contact.stiffness = lead.stiffness;
  });
  const auto hand = open_hand(*session, context.seed);
  SessionConfig config = session->config;
  config.duration = seconds;
  config.contact_every = config.contact_latency = lead.every;
  config.haptic.device = hand->limits();
  LedRun run;
  run.summary = run_lockstep(config, *hand,
                             {.haptic = [&](const HapticSample& s) { run.frames.push_back(s); },
                              .contact = {},
                              .event = {}});
  if (lead.every == 1) run.missed = missed_depths(*session, run.frames, context.quick ? 100 : 50);
  return run;
}

/// Force above 300 Hz over its mean, over a second at a time where the hand presses all through:
/// the worst of them.
double noise(const LedRun& run) {
  constexpr std::size_t kSecond = 500;  // frames: half a second
  double worst = 0.0;
  for (std::size_t i = 0; i + kSecond <= run.frames.size(); i += kSecond / 2) {
    std::vector<double> force;
    for (std::size_t k = i; k < i + kSecond; ++k)
      force.push_back(run.frames[k].feedback.force.norm());
    if (*std::min_element(force.begin(), force.end()) < 0.2) continue;
    worst = std::max(worst, band_level(force, 1e-3, 300.0, 499.0) / mean(force));
  }
  return worst > 0.0 ? worst : std::numeric_limits<double>::quiet_NaN();
}

/// The worst of several runs.
struct Worst {
  double noise = 0.0, events = 0.0, energy = 0.0;

  explicit Worst(const LedRun& first)
      : noise(hammer_on_torus::noise(first)),
        events(static_cast<double>(first.summary.safety_events.size())),
        energy(first.summary.energy_min) {}

  void add(const LedRun& run) {
    const double here = hammer_on_torus::noise(run);
    if (std::isfinite(here)) noise = std::max(noise, here);
    events += static_cast<double>(run.summary.safety_events.size());
    energy = std::min(energy, run.summary.energy_min);
  }
};

double quantile_or_nan(const std::vector<double>& values, double share) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : sample_quantile(values, share);
}

/// The led scenes: what they are like for the hand.
Table led_table() {
  return {.name = "data",
          .columns = {"scene", "gradient", "force max [N]", "depth max [m]", "above 300 Hz / mean",
                      "energy min [J]", "safety events", "contact step p50 [s]",
                      "contact step p99 [s]", "missed mean", "missed p99"}};
}

LedRun lead_and_note(const Context& context, const Lead& lead, Table& table) {
  tell(context, lead.scene);
  const LedRun run = lead_scene(context, lead, context.quick ? 3.0 : 10.0);
  const SessionSummary& s = run.summary;
  add_row(table, {lead.scene, std::string(gradient_name(lead.gradient)), s.force_max,
                  s.penetration_max, noise(run), s.energy_min,
                  static_cast<double>(s.safety_events.size()), s.contact_step_cpu.p50,
                  s.contact_step_cpu.p99, run.missed.empty() ? std::nan("") : mean(run.missed),
                  quantile_or_nan(run.missed, 0.99)});
  return run;
}

/// Central differences where the text's pipeline was: slower models, stiffer contact, a coarser
/// grid.
double differences(const Context& context, Outcome& outcome) {
  Table table{.name = "differences",
              .columns = {"samples a side", "stiffness [N/m]", "contact models a second",
                          "above 300 Hz / mean", "force max [N]", "safety events"}};
  const double seconds = context.quick ? 2.0 : 4.0;
  double here = std::nan("");
  std::vector<Lead> leads;
  for (const int every : {1, 5, 10}) leads.push_back({.every = every});
  if (!context.quick) {
    for (const double stiffness : {10e3, 20e3}) leads.push_back({.stiffness = stiffness});
    for (const int resolution : {12, 25}) leads.push_back({.resolution = resolution});
  }
  for (Lead& lead : leads) {
    lead.gradient = GradientKind::central_differences;
    tell(context, "central differences");
    const LedRun run = lead_scene(context, lead, seconds);
    add_row(table,
            {static_cast<double>(lead.resolution), lead.stiffness, 1000.0 / lead.every, noise(run),
             run.summary.force_max, static_cast<double>(run.summary.safety_events.size())});
    if (std::isnan(here)) here = noise(run);
  }
  outcome.tables.push_back(std::move(table));
  return here;
}

}  // namespace
}  // namespace hammer_on_torus

Outcome run_hammer_on_torus(const Context& context) {
  using namespace hammer_on_torus;
  Outcome outcome;
  outcome.tables = {led_table()};
  outcome.figure = {.title = "Hammer on torus"};
  add_strokes(context, outcome);
  Table& led = outcome.tables.front();
  const LedRun hammer = lead_and_note(context, {}, led);
  Worst worst(hammer);
  std::vector<Claim> stated_last;
  for (const char* scene : {"file_on_cad", "blocks", "plate"}) {
    const LedRun run = lead_and_note(context, {.scene = scene}, led);
    worst.add(run);
    stated_last.push_back(stated(
        std::string("missed-") + scene,
        std::string("depth the grid misses, 99 % of contacts below, share of the amplitudes: ") +
            scene,
        quantile_or_nan(run.missed, 0.99)));
    stated_last.push_back(stated(std::string("step-") + scene,
                                 std::string("CPU time of a contact step, p99: ") + scene,
                                 run.summary.contact_step_cpu.p99, "s"));
  }
  const double rough = differences(context, outcome);
  const std::vector<Claim> claims = {
      at_most("stable", "safety events of four textured scenes", worst.events, 0.0),
      at_most("noise", "force above 300 Hz over its mean while pressed, the worst of four scenes",
              worst.noise, 0.02),
      at_least("energy", "least energy at the port, the worst of four scenes", worst.energy, -1e-4,
               "J"),
      stated("rate",
             "contact steps a second of CPU time, 99 % of them faster; the text's 100 to 200",
             1.0 / hammer.summary.contact_step_cpu.p99, "Hz"),
      stated("depth-error", "depth the grid misses on average, share of the amplitudes",
             hammer.missed.empty() ? std::nan("") : mean(hammer.missed)),
      stated("depth-error-p99", "the same, 99 % of contacts below",
             quantile_or_nan(hammer.missed, 0.99)),
      at_most("noise-differences",
              "with central differences, where the text's hammer was unstable: force above 300 Hz "
              "over its mean",
              rough, 0.02),
      known_not_to(above("unstable",
                         "as the text at 50 x 50: with central differences the force above "
                         "300 Hz exceeds a tenth of the mean",
                         rough, 0.1),
                   {"not wanted: the model of the haptic thread is implicit with a Gauss-Newton "
                    "Jacobian and the depth "
                    "is climbed to below texel size; slower models, a stiffer contact and a "
                    "coarser grid do not bring it back",
                    "differences.csv", 0.0})};
  outcome.claims.insert(outcome.claims.end(), claims.begin(), claims.end());
  outcome.claims.insert(outcome.claims.end(), stated_last.begin(), stated_last.end());
  return outcome;
}

}  // namespace thigma::experiments
