#include "thigma/simulation/simulate.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/cpu_clock.h"
#include "thigma/core/error.h"
#include "thigma/simulation/detail/safe_time.h"
#include "thigma/simulation/free_motion.h"

namespace thigma {
namespace {

using detail::collision_gap;
using detail::safe_time;
using detail::Touch;
using detail::touch_of;

constexpr int kMostImpulses = 400;      // of one event
constexpr double kStill = 0.025;     // without motion: at rest [s]
constexpr int kHeld = 8;             // events in that time, at least: a body at the top of its flight is not at rest
constexpr int kFullHits = 4;         // of one contact within an event: those after bounce less and less
constexpr double kAtRest = 1e-9;        // approach that counts as none, of the speed that the tolerance is fallen with

// Speed with which a body falls over a height.
double fall_speed(const SimulationWorld& world, double height) {
  return std::sqrt(2.0 * world.body.gravity.norm() * height);
}

bool is_finite(const BodyState& s) {
  return s.position.allFinite() && s.orientation.coeffs().allFinite() && s.linear_momentum.allFinite() &&
         s.angular_momentum.allFinite();
}

class Simulation {
 public:
  Simulation(const SimulationWorld& world, SimulationState& state, SimulationScratch& scratch,
             const SimulationPorts& ports)
      : world_(world), state_(state), scratch_(scratch), ports_(ports) {
    const Pose mesh = world.body_from_mesh;
    reach_ = (transform_point(mesh, world.object->center)).norm() + 1.02 * world.object->radius;
    slow_ = fall_speed(world, detail::kShortestFall * collision_gap(world));
  }

  SimulationCounts run(double duration) {
    const double end = state_.time + duration;
    query();
    while (state_.time < end && !state_.is_resting && is_finite(state_.body)) {
      counts_.deepest = std::max(counts_.deepest, -least_distance(scratch_.contacts));
      state_.held += collide(scratch_.contacts);
      advance(end - state_.time);
      watch_motion();
    }
    if (state_.is_resting) state_.time = end;
    return counts_;
  }

 private:
  void query() {
    ContactQuery q{.tolerance = world_.tolerance, .resolution = world_.resolution};
    q.resolution.interpolates = false;
    q.resolution.step_time = std::max(state_.since_query, 1e-9);
    const Pose world_from_mesh = Pose{state_.body.position, state_.body.orientation} * world_.body_from_mesh;
    const double start = thread_cpu_seconds();
    query_scene(*world_.object, world_from_mesh, world_.scene, q, scratch_.fronts, scratch_.contacts);
    counts_.query_cpu += thread_cpu_seconds() - start;
    counts_.front += static_cast<double>(scratch_.contacts.stats.front);
    ++counts_.steps;
    state_.since_query = 0.0;
    if (ports_.query) ports_.query(state_, scratch_.contacts);
  }

  // ---- rest -------------------------------------------------------------------------------------------------------

  double moved() const {
    const BodyState& from = state_.moved_from;
    const Quat turn = state_.body.orientation * from.orientation.conjugate();
    return (state_.body.position - from.position).norm() + 2.0 * turn.vec().norm() * reach_;
  }

  void watch_motion() {
    if (state_.moved_at < 0.0 || moved() > 0.5 * world_.tolerance) {
      state_.moved_from = state_.body;
      state_.moved_at = state_.time;
      state_.held = 0;
    }
    if (state_.time - state_.moved_at < kStill || state_.held < kHeld) return;
    state_.is_resting = true;
    state_.body.linear_momentum.setZero();
    state_.body.angular_momentum.setZero();
  }

  // ---- events -----------------------------------------------------------------------------------------------------

  // Impulses at everything that touches and approaches, the fastest first. A contact that is hit again bounces less.
  bool collide(const ContactSet& set) {
    const double near = collision_gap(world_);
    scratch_.touching.clear();
    for (std::size_t i = 0; i < set.contacts.size(); ++i) {
      if (-set.contacts[i].depth <= near) scratch_.touching.push_back(static_cast<std::int32_t>(i));
    }
    scratch_.hits.assign(scratch_.touching.size(), 0);
    const double least = kAtRest * std::max(slow_, fall_speed(world_, world_.tolerance));
    int impulses = 0;
    for (; impulses < kMostImpulses; ++impulses) {
      double fastest = least;
      std::size_t which = scratch_.touching.size();
      for (std::size_t k = 0; k < scratch_.touching.size(); ++k) {
        const double approach =
            touch_of(world_, state_.body, set.contacts[static_cast<std::size_t>(scratch_.touching[k])]).approach;
        if (approach > fastest) {
          fastest = approach;
          which = k;
        }
      }
      if (which == scratch_.touching.size()) break;
      hit(set.contacts[static_cast<std::size_t>(scratch_.touching[which])], scratch_.hits[which]++);
    }
    counts_.impulses += impulses;
    counts_.events += impulses > 0;
    counts_.unresolved += impulses == kMostImpulses;
    return impulses > 0;
  }

  double restitution(const Touch& t, int hits) const {
    const double slow = t.gap < 0.5 * collision_gap(world_) ? 4.0 * slow_ : slow_;
    const double rest = slow > 0.0 ? std::clamp(t.approach / slow - 1.0, 0.0, 1.0) : 1.0;
    return std::ldexp(1.0 - (1.0 - world_.law.restitution) * rest, -std::max(hits - kFullHits, 0));
  }

  void hit(const Contact& c, int hits) {
    const Touch t = touch_of(world_, state_.body, c);
    const CollisionLaw law{restitution(t, hits), world_.law.friction};
    const Mat3 matrix = collision_matrix(world_.body, state_.body, t.arm);
    const Vec3 impulse = collision_impulse(matrix, point_velocity(world_.body, state_.body, t.arm), c.normal, law);
    const double before = kinetic_energy(world_.body, state_.body);
    state_.body = with_impulse(state_.body, t.arm, impulse);
    if (!ports_.event) return;
    ports_.event({.time = state_.time,
                  .point = c.point,
                  .normal = c.normal,
                  .impulse = impulse,
                  .approach = t.approach,
                  .energy_change = kinetic_energy(world_.body, state_.body) - before,
                  .gap = t.gap,
                  .object_level = c.object_level,
                  .scene_level = c.scene_level});
  }

  // ---- time -------------------------------------------------------------------------------------------------------

  void move(double time) {
    state_.body = free_motion(world_.body, state_.body, time);
    state_.time += time;
    state_.since_query += time;
  }

  // Flies on to the next query. Where that finds levels in penetration which those before did not have, the event was
  // in between.
  void advance(double left) {
    const double gap = std::min(world_.tolerance, least_distance(scratch_.contacts));
    const double time = std::min({safe_time(world_, state_.body, scratch_.contacts, reach_), world_.longest_step, left});
    const SimulationState from = state_;
    move(time);
    if (left - time < 1e-12 * (state_.time + left)) state_.time = from.time + left;
    query();
    const double depth = -least_distance(scratch_.contacts);
    if (!(depth > collision_gap(world_)) || !(gap > 0.0)) return;
    const double part = gap / (gap + depth);
    const SimulationState there = state_;
    state_ = from;
    move(part * time);
    if (collide(scratch_.contacts)) {
      ++counts_.interpolated;
      query();
    } else {
      state_ = there;
    }
  }

  const SimulationWorld& world_;
  SimulationState& state_;
  SimulationScratch& scratch_;
  const SimulationPorts& ports_;
  SimulationCounts counts_;
  double reach_ = 0.0;  // of the mesh from the centre of mass
  double slow_ = 0.0;   // impacts below keep their speed
};

void check(const SimulationWorld& world) {
  if (world.object == nullptr) throw InputError("simulation: no moving object");
  if (!(world.tolerance > 0.0) || !std::isfinite(world.tolerance))
    throw InputError("simulation: tolerance, expected a finite length above 0 [m]");
  if (!(world.longest_step > 0.0)) throw InputError("simulation: longest step, expected a time above 0 [s]");
  if (!(world.law.restitution >= 0.0 && world.law.restitution <= 1.0))
    throw InputError("simulation: restitution, expected 0 to 1");
  if (!(world.law.friction >= 0.0)) throw InputError("simulation: friction, expected 0 or more");
}

}  // namespace

SimulationScratch reserve_simulation(const SimulationWorld& world, std::size_t contacts) {
  check(world);
  SimulationScratch scratch;
  scratch.fronts.resize(world.scene.size());
  for (std::size_t i = 0; i < world.scene.size(); ++i)
    reserve_front(scratch.fronts[i], *world.object, *world.scene[i].hierarchy);
  scratch.contacts.contacts.reserve(contacts);
  scratch.touching.reserve(contacts);
  scratch.hits.reserve(contacts);
  return scratch;
}

SimulationCounts simulate(const SimulationWorld& world, double duration, SimulationState& state,
                          SimulationScratch& scratch, const SimulationPorts& ports) {
  return Simulation(world, state, scratch, ports).run(duration);
}

}  // namespace thigma
