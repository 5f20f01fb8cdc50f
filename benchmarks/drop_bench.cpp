#include "benchmarks/drop_bench.h"

#include <algorithm>
#include <cstdio>

#include "thigma/clod/build_clod.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/mesh/measure.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/simulated_body.h"
#include "thigma/simulation/simulate.h"

namespace thigma::bench {
namespace {

constexpr double kFrame = 0.030;  // [s]
constexpr double kLongest = 3.0;  // of the simulation [s]
constexpr std::size_t kDropRoom = 20'000;

/// The world of the built-in scene, with hierarchies of its own.
struct DropCase {
  ClodHierarchy spoon, cup;
  SimulationWorld world;
  SimulationState start;
};

void set_up(bool quick, DropCase& drop) {
  SceneDescription scene = read_scene("spoon_in_cup");
  if (quick) scene.object.model->triangles = scene.statics[0].model->triangles = 3000;
  LoadedObject spoon = load_object(scene.object);
  const LoadedObject cup = load_object(scene.statics[0]);
  drop.spoon = build_clod(spoon.mesh);
  drop.cup = build_clod(cup.mesh);
  SessionConfig config = make_session_config(scene, spoon, drop.spoon,
                                             {{&drop.cup, scene.statics[0].world_from_mesh}});
  config.contact.tolerance = 1e-3 * std::min(drop.spoon.radius, drop.cup.radius);
  config.contact.resolution = {};
  const SimulatedBody& body = *scene.simulation;
  drop.world = simulation_world(body, config);
  drop.start = simulation_start(body, config, 1);
}

/// Poses of the queries by frame, until the spoon rests.
std::vector<std::vector<Pose>> play(const DropCase& drop, bool quick) {
  std::vector<std::vector<Pose>> frames;
  SimulationState state = drop.start;
  SimulationScratch scratch = reserve_simulation(drop.world);
  SimulationPorts ports;
  ports.query = [&](const SimulationState& s, const ContactSet&) {
    frames.back().push_back(Pose{s.body.position, s.body.orientation} * drop.world.body_from_mesh);
  };
  for (double t = 0.0; t < (quick ? 0.3 : kLongest) && !state.is_resting; t += kFrame) {
    frames.emplace_back();
    simulate(drop.world, kFrame, state, scratch, ports);
  }
  return frames;
}

struct DropTiming {
  std::vector<double> seconds;         // mean query of each frame
  double front = 0.0, contacts = 0.0;  // means over the queries
};

DropTiming measure(const DropCase& drop, const std::vector<std::vector<Pose>>& frames,
                   const Resolution& resolution) {
  DropTiming timing;
  const SceneBody& cup = drop.world.scene.front();
  const ContactQuery query{.tolerance = drop.world.tolerance, .resolution = resolution};
  ContactFront front;
  reserve_front(front, drop.spoon, drop.cup);
  ContactSet set;
  set.contacts.reserve(kDropRoom);
  double queries = 0.0;
  for (const std::vector<Pose>& frame : frames) {
    double seconds = 0.0;
    for (const Pose& pose : frame) {
      clear(set);
      const double start = thread_cpu();
      query_contacts({drop.spoon, pose}, {drop.cup, cup.world_from_body}, query, front, set);
      seconds += thread_cpu() - start;
      timing.front += static_cast<double>(set.stats.front);
      timing.contacts += static_cast<double>(set.contacts.size());
    }
    queries += static_cast<double>(frame.size());
    timing.seconds.push_back(seconds / static_cast<double>(frame.size()));
  }
  timing.front /= queries;
  timing.contacts /= queries;
  return timing;
}

double mean_us(const DropTiming& timing) {
  double sum = 0.0;
  for (const double s : timing.seconds) sum += s;
  return 1e6 * sum / static_cast<double>(timing.seconds.size());
}

}  // namespace

std::vector<Row> drop_rows(bool quick) {
  DropCase drop;
  set_up(quick, drop);
  const std::vector<std::vector<Pose>> frames = play(drop, quick);
  const DropTiming exact = measure(drop, frames, Resolution{});
  std::vector<Row> rows;
  for (const double cap : {kNoCap, 0.02}) {
    Resolution levels;
    levels.is_exact = false;
    levels.metric.haptic = 0.035;
    levels.deviation_cap = cap;
    levels.interpolates = false;
    const DropTiming ours = measure(drop, frames, levels);
    Row row;
    row.name = std::string("spoon falls into cup, levels s0 = 3.5 %, ") +
               (cap == kNoCap ? "no cap" : "cap 2 %");
    row.unit = "us";
    row.ours = figure_of(ours.seconds, 1e6);
    row.baseline = "exact on the same asset";
    row.theirs = figure_of(exact.seconds, 1e6);
    row.contacts_ours = ours.contacts;
    row.contacts_baseline = exact.contacts;
    row.front = ours.front;
    row.front_exact = exact.front;
    row.speedup = row.theirs->p50 / row.ours.p50;
    char note[160];
    std::snprintf(
        note, sizeof note,
        "mean query of each of %zu frames of 30 ms until rest; average %.1f us, exact %.1f us",
        frames.size(), mean_us(ours), mean_us(exact));
    row.note = note;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace thigma::bench
