#include "thigma/simulation/simulate.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/cpu_clock.h"
#include "thigma/core/error.h"
#include "thigma/simulation/detail/safe_time.h"
#include "thigma/simulation/detail/support.h"
#include "thigma/simulation/free_motion.h"

namespace thigma {
namespace {

using detail::approaching;
using detail::ApproachingContact;
using detail::collision_gap;
using detail::gap_of;
using detail::least_gap;
using detail::PushedFlight;
using detail::safe_time;

constexpr int kMostImpulses = 400;  // of one event
// least flight, of the longest, where a change of levels has left surfaces deep in others
constexpr double kLostStep = 0.1;
// of a flight: its time depends on the forces, and they on it
constexpr int kMostPlans = 4;
constexpr double kStill = 0.025;  // without motion: at rest [s]
// tolerances, of the fall that a settling body is not expected to take
constexpr double kSettled = 100.0;
// of the weight, meanwhile: a body at the top of its flight is not at rest
constexpr double kCarried = 0.9;
// of one contact within an event: those after bounce less and less
constexpr int kFullHits = 4;
// of what a contact has sunk, per flight: the most that energy allows
constexpr double kLifts[] = {0.2, 0.0};
// approach that counts as none, of the speed that the tolerance is fallen with
constexpr double kAtRest = 1e-9;

// Speed with which a body falls over a height.
double fall_speed(const SimulationWorld& world, double height) {
  return std::sqrt(2.0 * world.body.gravity.norm() * height);
}

bool is_finite(const BodyState& s) {
  return s.position.allFinite() && s.orientation.coeffs().allFinite() &&
         s.linear_momentum.allFinite() && s.angular_momentum.allFinite();
}

class Simulation {
 public:
  Simulation(const SimulationWorld& world, SimulationState& state, SimulationScratch& scratch,
             const SimulationPorts& ports)
      : world_(world), state_(state), scratch_(scratch), ports_(ports) {
    const Pose mesh = world.body_from_mesh;
    reach_ = (transform_point(mesh, world.object->center)).norm() + 1.02 * world.object->radius;
    if (world.body.gravity.norm() > 0.0) up_ = -world.body.gravity.normalized();
    bounce_threshold_ = fall_speed(world, detail::kShortestFall * collision_gap(world));
  }

  SimulationCounts run(double duration) {
    const double end = state_.time + duration;
    query();
    while (state_.time < end && !state_.is_resting && is_finite(state_.body)) {
      counts_.deepest = std::max(counts_.deepest, -seen_);
      collide(scratch_.contacts);
      advance(end - state_.time);
      watch_motion();
    }
    if (state_.is_resting) state_.time = end;
    return counts_;
  }

 private:
  void query() {
    ContactQuery q{.tolerance = world_.tolerance, .resolution = world_.resolution};
    q.resolution.is_exact |= state_.is_settling;
    q.resolution.interpolates = false;
    q.resolution.step_time = std::max(state_.since_query, 1e-9);
    const Pose world_from_mesh =
        Pose{state_.body.position, state_.body.orientation} * world_.body_from_mesh;
    const double start = thread_cpu_seconds();
    query_scene({*world_.object, world_from_mesh}, world_.scene, q, scratch_.fronts,
                scratch_.contacts);
    counts_.query_cpu += thread_cpu_seconds() - start;
    counts_.front += static_cast<double>(scratch_.contacts.stats.front);
    ++counts_.steps;
    seen_ = least_distance(scratch_.contacts);
    for (const Contact& c : scratch_.contacts.contacts)
      counts_.beyond_bound = std::max(counts_.beyond_bound, c.depth - c.bound);
    state_.since_query = 0.0;
    if (ports_.query) ports_.query(state_, scratch_.contacts);
    if (is_in_doubt()) {
      add_exact_contacts(world_from_mesh);
      seen_ = least_distance(scratch_.exact);
    }
    least_ = least_gap(world_, scratch_.contacts);
  }

  // Whether levels leave open that something touches: the direction they give is theirs alone then.
  bool is_in_doubt() const {
    const auto& all = scratch_.contacts.contacts;
    return world_.allows_for_bounds && std::any_of(all.begin(), all.end(), [&](const Contact& c) {
             return c.bound > 0.0 && gap_of(world_, c) <= collision_gap(world_);
           });
  }

  void add_exact_contacts(const Pose& world_from_mesh) {
    ++counts_.doubted;
    const double start = thread_cpu_seconds();
    query_scene({*world_.object, world_from_mesh}, world_.scene, {.tolerance = world_.tolerance},
                scratch_.exact_fronts, scratch_.exact);
    counts_.query_cpu += thread_cpu_seconds() - start;
    auto& all = scratch_.contacts.contacts;
    const auto& exact = scratch_.exact.contacts;
    const std::size_t count = std::min(exact.size(), all.capacity() - all.size());
    all.insert(all.end(), exact.begin(), exact.begin() + static_cast<std::ptrdiff_t>(count));
  }

  // ---- rest
  // ------------------------------------------------------------

  double moved() const {
    const BodyState& from = state_.moved_from;
    const Quat turn = state_.body.orientation * from.orientation.conjugate();
    return (state_.body.position - from.position).norm() + 2.0 * turn.vec().norm() * reach_;
  }

  // Whether all that carries the body are levels that may lie off.
  bool hovers() const {
    if (state_.is_settling || !world_.allows_for_bounds) return false;
    const auto& all = scratch_.contacts.contacts;
    return std::none_of(all.begin(), all.end(), [&](const Contact& c) {
      return c.bound <= world_.tolerance && -c.depth <= collision_gap(world_);
    });
  }

  void watch_motion() {
    if (state_.moved_at < 0.0 || moved() > 0.5 * world_.tolerance) {
      state_.moved_from = state_.body;
      state_.moved_at = state_.time;
      state_.weight_impulse = 0.0;
    }
    if (state_.is_settling && velocity(world_.body, state_.body).linear.norm() >
                                  fall_speed(world_, kSettled * world_.tolerance))
      state_.is_settling = false;
    const double still = state_.time - state_.moved_at;
    const double weight = world_.body.mass * world_.body.gravity.norm();
    if (still < kStill || state_.weight_impulse < kCarried * weight * still) return;
    if (hovers()) {
      state_.is_settling = true;
      state_.moved_at = -1.0;  // watched anew: what weight_impulse it so far did not
      return;
    }
    state_.is_resting = true;
    state_.body.linear_momentum.setZero();
    state_.body.angular_momentum.setZero();
  }

  // ---- events
  // ------------------------------------------------------------

  // Impulses at everything that touches and approaches, the fastest first. A contact that is hit
  // again bounces less.
  bool collide(const ContactSet& set) {
    const double near = collision_gap(world_);
    scratch_.touching.clear();
    for (std::size_t i = 0; i < set.contacts.size(); ++i) {
      if (gap_of(world_, set.contacts[i]) <= near)
        scratch_.touching.push_back(static_cast<std::int32_t>(i));
    }
    scratch_.hits.assign(scratch_.touching.size(), 0);
    const double least =
        kAtRest * std::max(bounce_threshold_, fall_speed(world_, world_.tolerance));
    int impulses = 0;
    for (; impulses < kMostImpulses; ++impulses) {
      double fastest = least;
      std::size_t which = scratch_.touching.size();
      for (std::size_t k = 0; k < scratch_.touching.size(); ++k) {
        const double approach =
            approaching(world_, state_.body,
                        set.contacts[static_cast<std::size_t>(scratch_.touching[k])])
                .approach;
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

  double restitution(const ApproachingContact& t, int hits) const {
    const bool has_sunk = t.gap < 0.5 * collision_gap(world_) && t.gap > -world_.tolerance;
    const double slow = has_sunk ? 4.0 * bounce_threshold_ : bounce_threshold_;
    const double fast = slow > 0.0 ? std::clamp(t.approach / slow - 1.0, 0.0, 1.0) : 1.0;
    const double kept = fast * world_.law.restitution + (has_sunk ? 1.0 - fast : 0.0);
    return std::ldexp(kept, -std::max(hits - kFullHits, 0));
  }

  void hit(const Contact& c, int hits) {
    const ApproachingContact t = approaching(world_, state_.body, c);
    const CollisionLaw law{restitution(t, hits), world_.law.friction};
    const Mat3 matrix = collision_matrix(world_.body, state_.body, t.arm);
    const Vec3 impulse =
        collision_impulse(matrix, point_velocity(world_.body, state_.body, t.arm), c.normal, law);
    const double before = kinetic_energy(world_.body, state_.body);
    state_.body = with_impulse(state_.body, t.arm, impulse);
    state_.weight_impulse += up_.dot(impulse);
    if (!ports_.event) return;
    ports_.event({.time = state_.time,
                  .point = c.point,
                  .normal = c.normal,
                  .impulse = impulse,
                  .approach = t.approach,
                  .energy_change = kinetic_energy(world_.body, state_.body) - before,
                  .gap = -c.depth,
                  .object_level = c.object_level,
                  .scene_level = c.scene_level});
  }

  // ---- time
  // ------------------------------------------------------------

  void move(const PushedFlight& flight, double part = 1.0) {
    const double time = part * flight.time;
    state_.body = pushed_motion(world_.body, state_.body, flight.push, time);
    state_.weight_impulse += time * up_.dot(flight.push.force);
    state_.time += time;
    state_.since_query += time;
  }

  bool is_held() const { return !scratch_.touching.empty() && bounce_threshold_ > 0.0; }

  // The longest flight that is safe under the forces that hold the body over it.
  PushedFlight plan(double longest, double lift) {
    PushedFlight flight{longest, {}};
    const bool is_lost = -seen_ > world_.tolerance;
    for (int i = 0; i < kMostPlans; ++i) {
      if (is_held()) {
        flight.push =
            detail::support_wrench(world_, state_.body, {scratch_.contacts, scratch_.touching},
                                   {flight.time, lift}, scratch_.supports);
      }
      const double safe = safe_time(world_, state_.body, scratch_.contacts, reach_, flight);
      if (safe >= flight.time) break;
      flight.time = std::max(safe, is_lost ? kLostStep * longest : 0.0);
    }
    return flight;
  }

  // Takes out of the motion what energy is above this; false where motion has not so much.
  bool dissipate_excess_energy(double energy) {
    const double excess = mechanical_energy(world_.body, state_.body) - energy;
    if (!(excess > 0.0)) return true;
    const double motion = kinetic_energy(world_.body, state_.body);
    if (excess > motion) return false;
    const double kept = std::sqrt((motion - excess) / motion);
    state_.body.linear_momentum *= kept;
    state_.body.angular_momentum *= kept;
    return true;
  }

  // Flies on for the longest safe time, held by what touches. Energy does not grow.
  PushedFlight advance_freely(double longest) {
    const SimulationState from = state_;
    scratch_.supports.clear();
    if (!is_held()) {
      const PushedFlight flight = plan(longest, 0.0);
      move(flight);
      return flight;
    }
    ++counts_.supported;
    const double energy = mechanical_energy(world_.body, state_.body);
    for (const double lift : kLifts) {
      const PushedFlight flight = plan(longest, lift);
      move(flight);
      const bool is_paid = mechanical_energy(world_.body, state_.body) <= energy;
      if (is_paid || (lift == 0.0 && dissipate_excess_energy(energy))) return flight;
      state_ = from;
    }
    const PushedFlight free{
        std::min(longest, safe_time(world_, state_.body, scratch_.contacts, reach_)), {}};
    move(free);
    return free;
  }

  // Flies on to the next query. Where that finds levels in penetration which those before did not
  // have, the event was in between.
  void advance(double left) {
    const double gap = std::min(world_.tolerance, least_);
    const SimulationState from = state_;
    const PushedFlight flight = advance_freely(std::min(left, world_.longest_step));
    if (left - flight.time < 1e-12 * (state_.time + left)) state_.time = from.time + left;
    query();
    const double depth = -least_;
    if (!(depth > collision_gap(world_)) || !(gap > 0.0)) return;
    const SimulationState there = state_;
    const double energy = mechanical_energy(world_.body, from.body);
    state_ = from;
    const double part = gap / (gap + depth);
    move(flight, part);
    state_.since_query = (1.0 - part) * flight.time;  // the query before was of the flight's end
    if (dissipate_excess_energy(energy) && collide(scratch_.contacts)) {
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
  double reach_ = 0.0;             // of the mesh from the centre of mass
  Vec3 up_ = Vec3::Zero();         // against gravity
  double bounce_threshold_ = 0.0;  // impacts below end without a bounce
  double seen_ = 0.0;   // distance that the last query saw, the exact one where it was asked [m]
  double least_ = 0.0;  // the same with what levels may lie off: the least gap [m]
};

void check(const SimulationWorld& world) {
  if (world.object == nullptr) throw InputError("simulation: no moving object");
  if (!(world.tolerance > 0.0) || !std::isfinite(world.tolerance))
    throw InputError("simulation: tolerance, expected a finite length above 0 [m]");
  if (!(world.longest_step > 0.0))
    throw InputError("simulation: longest step, expected a time above 0 [s]");
  if (!(world.law.restitution >= 0.0 && world.law.restitution <= 1.0))
    throw InputError("simulation: restitution, expected 0 to 1");
  if (!(world.law.friction >= 0.0)) throw InputError("simulation: friction, expected 0 or more");
  if (!(world.law.rolling >= 0.0))
    throw InputError("simulation: rolling friction, expected a length of 0 or more [m]");
}

}  // namespace

SimulationScratch reserve_simulation(const SimulationWorld& world, std::size_t contacts) {
  check(world);
  SimulationScratch scratch;
  for (std::vector<ContactFront>* fronts : {&scratch.fronts, &scratch.exact_fronts}) {
    fronts->resize(world.scene.size());
    for (std::size_t i = 0; i < world.scene.size(); ++i)
      reserve_front((*fronts)[i], *world.object, *world.scene[i].hierarchy);
    if (world.resolution.is_exact || !world.allows_for_bounds) break;  // no second query
  }
  scratch.contacts.contacts.reserve(contacts);
  scratch.exact.contacts.reserve(contacts);
  scratch.touching.reserve(contacts);
  scratch.hits.reserve(contacts);
  scratch.supports.reserve(contacts);
  return scratch;
}

SimulationCounts simulate(const SimulationWorld& world, double duration, SimulationState& state,
                          SimulationScratch& scratch, const SimulationPorts& ports) {
  return Simulation(world, state, scratch, ports).run(duration);
}

}  // namespace thigma
