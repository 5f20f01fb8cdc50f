// Fig. 3.18: levels of detail chosen by the velocity-dependent metric, coarse while the spoon
// falls, fine while it slides.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/spoon_drop.h"
#include "experiments/common/statistics.h"

namespace thigma::experiments {
namespace fig_3_18 {
namespace {

constexpr double kCoarsest = 0.035;  // s0 at the speed of the first impact, over the radius

/// One query with contacts, at the fastest of them.
struct Sight {
  double time, speed;       // [s, m/s]
  double coarsest, finest;  // level of the spoon or the cup
  double triangles;         // mean over the contacts, of both at their levels
};

Sight look(const SimulationWorld& world, const SimulationState& state, const ContactSet& set) {
  Sight sight{.time = state.time, .speed = 0.0, .coarsest = 0.0, .finest = 100.0, .triangles = 0.0};
  const ClodHierarchy& a = *world.object;
  const ClodHierarchy& b = *world.scene.front().hierarchy;
  const auto count = [](const ClodHierarchy& h, std::int32_t level) {
    return static_cast<double>(h.levels[static_cast<std::size_t>(level)].triangle_count);
  };
  for (const Contact& c : set.contacts) {
    const Vec3 arm = c.point - state.body.position;
    sight.speed = std::max(sight.speed, point_velocity(world.body, state.body, arm).norm());
    const double coarse = std::max(c.object_level, c.scene_level),
                 fine = std::min(c.object_level, c.scene_level);
    sight.coarsest = std::max(sight.coarsest, coarse);
    sight.finest = std::min(sight.finest, fine);
    sight.triangles += (count(a, c.object_level) + count(b, c.scene_level)) /
                       static_cast<double>(set.contacts.size());
  }
  return sight;
}

double first_impact_speed(SpoonDrop drop) {
  double speed = 0.0;
  SimulationPorts ports;
  ports.event = [&](const CollisionEvent& e) { speed = speed > 0.0 ? speed : e.approach; };
  SimulationScratch scratch = reserve_simulation(drop.world);
  for (int i = 0; i < 200 && !(speed > 0.0); ++i)
    simulate(drop.world, 0.005, drop.start, scratch, ports);
  return speed;
}

std::vector<double> column(const std::vector<Sight>& all, double Sight::*value, double low,
                           double high) {
  std::vector<double> v;
  for (const Sight& s : all) {
    if (s.speed >= low && s.speed <= high) v.push_back(s.*value);
  }
  return v;
}

/// A drop under the velocity metric. Depths are over the tolerance.
struct Fall {
  std::vector<Sight> sights;
  double deepest = 0.0;        // of what the simulation's queries saw
  double deepest_exact = 0.0;  // of what an exact query sees at the same poses
  double doubted = 0.0;        // share of queries with an exact one beside them
  double height = 0.0;         // of the centre of mass at the end [m]
};

// Exact queries beside those of a simulation.
class Witness {
 public:
  explicit Witness(const SimulationWorld& world)
      : world_(world), fronts_(reserve_simulation(world).fronts) {
    set_.contacts.reserve(20'000);
  }
  double depth(const SimulationState& state) {
    const Pose world_from_mesh =
        Pose{state.body.position, state.body.orientation} * world_.body_from_mesh;
    query_scene({*world_.object, world_from_mesh}, world_.scene, {.tolerance = world_.tolerance},
                fronts_, set_);
    return -least_distance(set_);
  }

 private:
  const SimulationWorld& world_;
  std::vector<ContactFront> fronts_;
  ContactSet set_;
};

Fall play(SpoonDrop drop, double seconds, double alpha, double cap, bool allows_for_bounds) {
  Resolution& resolution = drop.world.resolution;
  resolution.is_exact = false;
  resolution.deviation_cap = cap;
  resolution.metric = {.haptic = 0.0, .velocity = alpha};
  drop.world.allows_for_bounds = allows_for_bounds;
  Fall fall;
  Witness exact(drop.world);
  SimulationPorts ports;
  ports.query = [&](const SimulationState& state, const ContactSet& set) {
    if (set.contacts.empty()) return;  // nothing within the tolerance, exactly neither
    fall.sights.push_back(look(drop.world, state, set));
    fall.deepest_exact = std::max(fall.deepest_exact, exact.depth(state) / drop.world.tolerance);
  };
  SimulationState state = drop.start;
  SimulationScratch scratch = reserve_simulation(drop.world);
  const SimulationCounts counts = simulate(drop.world, seconds, state, scratch, ports);
  fall.deepest = counts.deepest / drop.world.tolerance;
  fall.doubted = static_cast<double>(counts.doubted) / static_cast<double>(counts.steps);
  fall.height = state.body.position.z();
  return fall;
}

/// Levels by which fast contacts are coarser than slow ones, and how many times fewer triangles
/// they have.
struct Coarsening {
  double levels = std::nan(""), triangles = std::nan("");
};

Coarsening coarsening(const std::vector<Sight>& sights, double impact) {
  const double fast = 0.5 * impact, slow = 0.1 * impact, none = 1e300;
  const std::vector<double> coarse = column(sights, &Sight::coarsest, fast, none);
  const std::vector<double> fine = column(sights, &Sight::finest, 0.0, slow);
  if (coarse.empty() || fine.empty()) return {};
  return {
      *std::max_element(coarse.begin(), coarse.end()) - *std::min_element(fine.begin(), fine.end()),
      mean(column(sights, &Sight::triangles, 0.0, slow)) /
          mean(column(sights, &Sight::triangles, fast, none))};
}

constexpr double kCaps[] = {kNoCap, 0.02, 0.01, 0.005, 0.003};  // of the radius

plot::Series curve(const char* label, const std::vector<Sight>& all, double Sight::*value) {
  plot::Series s{.label = label, .mark = plot::Mark::points};
  for (const Sight& one : all) {
    s.x.push_back(one.time);
    s.y.push_back(one.*value);
  }
  return s;
}

}  // namespace
}  // namespace fig_3_18

Outcome run_fig_3_18(const Context& context) {
  using namespace fig_3_18;
  SpoonDrop drop = spoon_drop(*context.assets, context.quick ? 20'000 : 0);
  const double impact = first_impact_speed(drop);
  const double alpha = kCoarsest * drop.radius / impact, seconds = context.quick ? 0.6 : 2.0;
  const Fall fall = play(drop, seconds, alpha, kNoCap, true);
  const std::vector<Sight>& sights = fall.sights;

  Outcome outcome;
  outcome.tables = {{.columns = {"time [s]", "fastest contact [m/s]", "coarsest level",
                                 "finest level", "triangles of both"}},
                    {.name = "sweep",
                     .columns = {"cap / radius", "allows for bounds", "deepest / tolerance",
                                 "deepest exact / tolerance", "levels coarser",
                                 "times fewer triangles", "height at the end [m]"}}};
  for (const Sight& s : sights)
    add_row(outcome.tables[0], {s.time, s.speed, s.coarsest, s.finest, s.triangles});
  double trusting = 0.0;  // deepest of the run that takes levels at their word
  for (const bool allows : {true, false}) {
    tell(context, allows ? "the same drop under caps on the deviation"
                         : "the same drops, levels taken at their word");
    for (const double cap : kCaps) {
      const Fall other = allows && cap == kNoCap ? fall : play(drop, seconds, alpha, cap, allows);
      const Coarsening c = coarsening(other.sights, impact);
      if (!allows && cap == kNoCap) trusting = other.deepest_exact;
      add_row(outcome.tables[1], {cap, allows ? 1.0 : 0.0, other.deepest, other.deepest_exact,
                                  c.levels, c.triangles, other.height});
    }
  }
  const Coarsening coarser = coarsening(sights, impact);
  outcome.claims = {
      at_least("coarser",
               "levels that the spoon's fast contacts are coarser than its slow ones, at most",
               coarser.levels, 4.0),
      at_least("triangles",
               "triangles of the levels in slow contacts over those in fast ones (the source: "
               "roughly 10)",
               coarser.triangles, 5.0),
      at_most("deepest",
              "penetration that the simulation's queries or exact ones beside them see, over the "
              "tolerance, at most",
              std::max(fall.deepest, fall.deepest_exact), 1.0),
      stated("doubted",
             "queries whose levels might touch, so that the simulation asked exactly as well",
             100.0 * fall.doubted, "%"),
      stated(
          "trusting",
          "`deepest` where contacts of simplified levels are taken at their word, as in the text",
          trusting, "tolerances"),
      stated("speed", "speed of the first impact", impact, "m/s")};
  outcome.figure = {
      .title = "Spoon into cup, velocity-dependent metric (Fig. 3.18)",
      .note =
          "each point a contact query; s0 = 3.5 % of the radius at the speed of the first impact",
      .panels = {{.title = "Speed",
                  .x = {.label = "time [s]", .low = 0.0},
                  .y = {.label = "fastest contact [m/s]", .low = 0.0}},
                 {.title = "Levels",
                  .x = {.label = "time [s]", .low = 0.0},
                  .y = {.label = "level (0 finest)", .low = -0.5}}}};
  outcome.figure.panels[0].series = {curve("", sights, &Sight::speed)};
  outcome.figure.panels[1].series = {curve("coarsest", sights, &Sight::coarsest),
                                     curve("finest", sights, &Sight::finest)};
  return outcome;
}

}  // namespace thigma::experiments
