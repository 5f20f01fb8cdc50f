// Relief under constraints, every scene that ships: how deep the fine surfaces come into each
// other, by code that knows no texture; what the engine counts; what a hand feels of ridges.

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/common/all_experiments.h"
#include "experiments/relief/fine_bodies.h"
#include "experiments/relief/ridges.h"

#include "thigma/scene/load_scene.h"
#include "thigma/scene/scene_file.h"

namespace thigma::experiments {
namespace relief {
namespace {

constexpr int kEvery[] = {1, 3, 10, 33};

/// A scene, and what its textures are off by: a bound on what the fine surfaces may enter.
struct ReliefScene {
  const char* name;
  double error;  // of the textures of both sides, largest (E10, table-4-1) [m]; 0: exact
};
// E10: depths against the fine meshes are off by up to 60 um.
const ReliefScene kScenes[] = {{"plate", 0.0},
                               {"blocks", 0.0},
                               {"block_on_gear", 6e-5},
                               {"file_on_cad", 6e-5},
                               {"hammer_on_torus", 6e-5}};

struct Ran {
  SessionSummary summary;
  double deepest = 0.0;  // [m]
  double amplitude = 0.0;
  long coarse = 0, bent = 0, left_out = 0;
};

/// A loaded scene with its fine surfaces.
struct Seen {
  Scene scene;
  DepthSurface object, fixed;
};

Seen open(const char* name, int step) {
  SceneDescription description = read_scene(name);
  description.contact.response = ResponseKind::constrained;
  Seen seen{load_scene(std::move(description)), {}, {}};
  const SceneDescription& d = seen.scene.description;
  seen.object = fine_surface(d.object, *seen.scene.object_textures[0], step);
  seen.fixed = fine_surface(d.statics[0], *seen.scene.static_textures[0][0], step);
  return seen;
}

Ran run(const Seen& seen, int every, double seconds, int looks) {
  SceneSession session = open_session(seen.scene, {.device = "hand:", .duration = seconds});
  session.config.contact_every = every;
  const ContactWorld& world = session.config.contact;
  Ran ran;
  ran.amplitude = world.textures.object.amplitude + world.textures.scene[0].amplitude;
  const int look = std::max(static_cast<int>(seconds / 1e-3) / looks, 1);
  int frame = 0;
  const auto haptic = [&](const HapticSample& s) {
    if (s.touching > 0 && frame++ % look == 0)
      ran.deepest = std::max(ran.deepest, vertex_depth(seen.object,
                                                       Pose{s.body.position, s.body.orientation} *
                                                           world.body_from_mesh,
                                                       seen.fixed, world.scene[0].world_from_body));
  };
  const auto contact = [&](const ContactSample& s) {
    ran.coarse += s.texture_coarse;
    ran.bent += s.texture_bent;
    ran.left_out += s.texture_left_out;
  };
  ran.summary = run_lockstep(session, {haptic, contact, {}});
  return ran;
}

void play_scene(const Context& context, const ReliefScene& scene, Outcome& outcome) {
  tell(context, scene.name);
  const Seen seen = open(scene.name, context.quick ? 4 : 2);
  const std::string name = scene.name;
  double deepest = 0.0, least = 0.0, amplitude = 0.0;
  int faults = 0;
  for (const int every : kEvery) {
    const Ran ran = run(seen, every, context.quick ? 2.0 : 5.0, context.quick ? 8 : 40);
    deepest = std::max(deepest, ran.deepest);
    least = std::min(least, ran.summary.energy_min);
    faults += ran.summary.end == SessionEnd::fault;
    amplitude = ran.amplitude;
    add_row(outcome.tables[0],
            {name, 1000.0 / every, 1e6 * ran.deepest, 100.0 * ran.deepest / ran.amplitude,
             1e6 * ran.summary.penetration_max, static_cast<double>(ran.coarse),
             static_cast<double>(ran.bent), static_cast<double>(ran.left_out),
             static_cast<double>(ran.summary.constraint.held_back_frames), ran.summary.energy_min,
             ran.summary.force_max, 1e6 * ran.summary.contact_step_cpu.p50,
             1e6 * ran.summary.contact_step_cpu.p99});
  }
  const double bound = std::max(0.02 * amplitude, scene.error);
  outcome.claims.push_back(at_most("depth-" + name,
                                   name + ": deepest between the fine surfaces, any rate (2 % of "
                                          "the amplitude, or what the textures are off by)",
                                   1e6 * deepest, 1e6 * bound, "um"));
  outcome.claims.push_back(
      at_least("energy-" + name, name + ": least energy at the port, any rate", least, -1e-6, "J"));
  outcome.claims.push_back(
      at_most("faults-" + name, name + ": runs that a fault ended", faults, 0.0));
}

void play_ridges(int every, double speed, Outcome& outcome) {
  const Felt felt = feel_ridges(every, speed);
  const std::string hertz = std::to_string(1000 / every),
                    mm = std::to_string(static_cast<int>(1e3 * speed + 0.5));
  const std::string id = "-" + hertz + "-" + mm,
                    here = "plate at " + hertz + " Hz, " + mm + " mm/s: ";
  add_row(outcome.tables[1],
          {1000.0 / every, 1e3 * speed, felt.rate, felt.decibel, felt.largest_step});
  // Far on the way of a slow contact frame the object waits: the force has its rate, too.
  const bool waits = every == 33 && speed > 0.05;
  const std::string peaks = here + "peaks of the force over ridges passed";
  outcome.claims.push_back(waits ? stated("rate" + id, peaks, felt.rate)
                                 : within("rate" + id, peaks, felt.rate, 0.98, 1.02));
  outcome.claims.push_back(
      within("swing" + id, here + "swing of the force over k_c times that of the probe's rest",
             felt.decibel, -1.0, 1.0, "dB"));
  outcome.claims.push_back(at_least("stable" + id, here + "the stroke ends without a fault",
                                    felt.is_stable ? 1.0 : 0.0, 1.0));
}

}  // namespace
}  // namespace relief

Outcome run_relief(const Context& context) {
  using namespace relief;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"scene", "contact rate [Hz]", "deepest, by fine meshes [um]",
                   "of the amplitude [%]", "penetration_max [um]", "coarse", "bent", "left out",
                   "frames held back", "least energy [J]", "largest force [N]",
                   "contact step p50 [us]", "contact step p99 [us]"}},
      {.name = "ridges",
       .columns = {"contact rate [Hz]", "speed [mm/s]", "peaks over ridges", "swing [dB]",
                   "largest step [N]"}}};
  for (const ReliefScene& scene : kScenes) {
    const bool is_slab = scene.error == 0.0;
    if (!context.quick || is_slab) play_scene(context, scene, outcome);
  }
  for (const double speed : {0.02, 0.1})
    for (const int every : kEvery) play_ridges(every, speed, outcome);
  plot::Panel panel{.x = {.label = "contact rate [Hz]", .is_log = true},
                    .y = {.label = "peaks of the force over ridges"}};
  plot::Series series{.label = "plate", .mark = plot::Mark::points};
  for (const auto& row : outcome.tables[1].rows) {
    series.x.push_back(std::get<double>(row[0]));
    series.y.push_back(std::get<double>(row[2]));
  }
  panel.series.push_back(series);
  outcome.figure = {.title = "Ridges of the plate under constraints", .panels = {panel}};
  return outcome;
}

}  // namespace thigma::experiments
