#include "thigma/multibody/hand_model.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma {

struct HandModelScratch {
  detail::PairModels pairs;  // of the body in the hand, made to hold for farther than a step
  std::vector<detail::BodyPairIndex> near;
  std::vector<double> gaps;
  struct Touch {
    double gap = 0.0;  // least of a row [m]
    detail::NearPair* pair = nullptr;
    std::size_t number = 0;  // of the pair
    double travel = 0.0;     // that is left of its model [m]
  };
  std::vector<Touch> touches;
};

namespace {

using detail::NearPair;

/// What a model is made of.
struct Making {
  const World& world;
  const WorldState& state;
  const WorldScratch& step;
  const HandModelRequest& request;
  HandModelScratch& s;
  HandModel& model;

  double reach(std::int32_t body) const noexcept {
    return world.boxes[idx(world.shape[idx(body)])].reach;
  }
  Vec6 velocity(std::int32_t body) const noexcept {
    const bool is_moving = moves_freely(world.bodies[idx(body)].kind);
    if (is_moving) return detail::velocity_of(world.rigid[idx(body)], state.bodies[idx(body)]);
    // What is prescribed has no momentum; its velocity is that of the step's solve.
    if (step.moves[idx(body)] != 0) return step.free[idx(body)].free;
    return Vec6::Zero();
  }
  /// Bound on how far a point of a body goes in a step of the world.
  double way(std::int32_t body) const noexcept {
    const Vec6 u = velocity(body);
    return request.step * (u.head<3>().norm() + reach(body) * u.tail<3>().norm());
  }
};

struct Box {
  Vec3 low, high;
};

Box box_of(const Making& m, std::int32_t body, double margin) noexcept {
  const ShapeBox& box = m.world.boxes[idx(m.world.shape[idx(body)])];
  const BodyState& y = m.state.bodies[idx(body)];
  const Mat3 rotation = rotation_matrix(y.orientation);
  const Vec3 middle = y.position + rotation * box.middle;
  const Vec3 half = rotation.cwiseAbs() * box.half + Vec3::Constant(margin);
  return {middle - half, middle + half};
}

bool overlap(const Box& a, const Box& b) noexcept {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

std::int32_t place_of(const HandModel& model, std::int32_t body) noexcept {
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    if (model.bodies[i].body == body) return static_cast<std::int32_t>(i);
  return -1;
}

/// Its place, -1 where there is no room for it.
std::int32_t add_body(const Making& m, std::int32_t body) noexcept {
  if (const std::int32_t place = place_of(m.model, body); place >= 0) return place;
  HandBody added;
  added.body = body;
  added.rigid = m.world.rigid[idx(body)];
  added.state = m.state.bodies[idx(body)];
  added.velocity = m.velocity(body);
  added.is_free = moves_freely(m.world.bodies[idx(body)].kind);
  if (!m.model.bodies.push_back(added)) return -1;
  return static_cast<std::int32_t>(m.model.bodies.size()) - 1;
}

/// The pair of the step of the same bodies; null: they were not near.
const NearPair* pair_of_step(const Making& m, std::int32_t first, std::int32_t second) noexcept {
  for (const NearPair* pair : m.step.pairs.near)
    if ((pair->first == first && pair->second == second) ||
        (pair->first == second && pair->second == first))
      return pair;
  return nullptr;
}

double gap_of(const ContactRow& row, const BodyState& relative, const Mat3& rotation) noexcept {
  return row_at(row, relative.position, rotation).gap;
}

/// Looks at all that the body in the hand may come near to, each pair with rows for its whole way.
void look_about(const Making& m, double way) {
  const std::int32_t held = m.request.body;
  HandModelScratch& s = m.s;
  s.near.clear();
  const Box box = box_of(m, held, way);
  const auto count = static_cast<std::int32_t>(m.world.bodies.size());
  for (std::int32_t other = 0; other < count; ++other) {
    if (other == held || never_touch(m.world, held, other)) continue;
    if (overlap(box, box_of(m, other, m.way(other))))
      s.near.push_back({std::min(held, other), std::max(held, other)});
  }
  std::sort(s.near.begin(), s.near.end());
  detail::take_pairs(m.world, s.near, s.pairs);
  s.touches.clear();
  for (NearPair* pair : s.pairs.near) {
    const BodyState relative =
        detail::relative_state(m.state.bodies[idx(pair->first)], m.state.bodies[idx(pair->second)]);
    // In the frame of one that turns the other goes farther.
    constexpr double kSpare = 1.25;
    const std::int32_t other = pair->first == held ? pair->second : pair->first;
    const double wanted = kSpare * (way + m.way(other));
    if (!detail::holds(m.world, *pair, relative, wanted)) {
      detail::PairCounts counts;
      detail::renew(m.world, relative, wanted, *pair, s.pairs, counts);
    }
    double least = kInfinity;
    const Mat3 rotation = rotation_matrix(relative.orientation);
    for (const ContactRow& row : pair->model.rows)
      least = std::min(least, gap_of(row, relative, rotation));
    const double reach = pair_kind(m.world, pair->kind).constraints.reach;
    const double travel = pair->model.travel - travel_between(pair->model.state, relative, reach);
    s.touches.push_back({least, pair, s.touches.size(), std::max(travel, 0.0)});
  }
  std::sort(s.touches.begin(), s.touches.end(), [](const auto& a, const auto& b) {
    return a.gap != b.gap ? a.gap < b.gap : a.number < b.number;
  });
}

/// Impulse and sliding of a row in the world's last step.
void take_history(const NearPair* of_step, HandRow& row) noexcept {
  if (of_step == nullptr) return;
  for (const detail::RowHistory& history : of_step->history) {
    if (history.id != row.row.id) continue;
    row.impulse = history.impulse;
    row.is_sliding = history.is_sliding;
    return;
  }
}

/// Rows of a pair with gaps up to `most`; false, and none, where there is no room for all.
bool add_rows(const Making& m, const NearPair& pair, const HandPair& made, double most) noexcept {
  HandModel& model = m.model;
  const BodyState relative =
      detail::relative_state(m.state.bodies[idx(pair.first)], m.state.bodies[idx(pair.second)]);
  const Mat3 rotation = rotation_matrix(relative.orientation);
  const std::size_t before = model.rows.size();
  if (!model.pairs.push_back(made)) return false;
  const NearPair* of_step = pair_of_step(m, pair.first, pair.second);
  for (const ContactRow& row : pair.model.rows) {
    if (gap_of(row, relative, rotation) > most) continue;
    HandRow added;
    added.row = row;
    added.pair = static_cast<std::int32_t>(model.pairs.size()) - 1;
    take_history(of_step, added);
    if (model.rows.push_back(added)) continue;
    while (model.rows.size() > before) model.rows.pop_back();
    model.pairs.pop_back();
    return false;
  }
  return true;
}

HandPair pair_of(const Making& m, const NearPair& pair) noexcept {
  HandPair made;
  const ConstraintWorld& constraints = pair_kind(m.world, pair.kind).constraints;
  made.first = place_of(m.model, pair.first);
  made.second = place_of(m.model, pair.second);
  made.state = pair.model.state;
  made.travel = pair.left_out > 0 ? 0.0 : pair.model.travel;
  made.reach = constraints.reach;
  made.slop = constraints.slop;
  made.restitution =
      restitution_between(m.world.bodies[idx(pair.first)], m.world.bodies[idx(pair.second)]);
  return made;
}

/// A pair of the body in the hand. Where there is no room for all its rows it gets the nearest, and
/// holds only until the first of the others could be met; without any, the body has that much room.
void add_touch(const Making& m, const HandModelScratch::Touch& touch) noexcept {
  const NearPair& pair = *touch.pair;
  const std::int32_t held = m.request.body;
  const std::int32_t other = pair.first == held ? pair.second : pair.first;
  // Without a row the pair is apart as far as its model has looked.
  const double apart = pair.left_out > 0 ? 0.0 : std::min(touch.gap, touch.travel);
  const double free_way = std::max(apart - m.way(other), 0.0);
  if (add_body(m, other) < 0) {
    ++m.model.left_out;
    m.model.room = std::min(m.model.room, free_way);
    return;
  }
  HandPair made = pair_of(m, pair);
  if (add_rows(m, pair, made, kInfinity)) return;
  ++m.model.left_out;
  const std::size_t left = kHandRows - m.model.rows.size();
  const BodyState relative =
      detail::relative_state(m.state.bodies[idx(pair.first)], m.state.bodies[idx(pair.second)]);
  const Mat3 rotation = rotation_matrix(relative.orientation);
  m.s.gaps.clear();
  for (const ContactRow& row : pair.model.rows) m.s.gaps.push_back(gap_of(row, relative, rotation));
  std::sort(m.s.gaps.begin(), m.s.gaps.end());
  if (left == 0 || m.s.gaps.size() <= left) {
    m.model.room = std::min(m.model.room, free_way);
    return;
  }
  // Gaps below that of the first without room.
  const double end = std::nextafter(m.s.gaps[left], -kInfinity);
  const double went = travel_between(made.state, relative, made.reach);
  made.travel = std::min(made.travel, went + std::max(end, 0.0));
  if (!add_rows(m, pair, made, end)) m.model.room = std::min(m.model.room, free_way);
}

bool has_pair(const HandModel& model, std::int32_t a, std::int32_t b) noexcept {
  for (const HandPair& pair : model.pairs)
    if ((pair.first == a && pair.second == b) || (pair.first == b && pair.second == a)) return true;
  return false;
}

/// Joints of a body that are not there yet; false where there is no room for all.
bool add_joints(const Making& m, std::int32_t body) noexcept {
  for (std::size_t k = 0; k < m.world.joints.size(); ++k) {
    const WorldJoint& joint = m.world.joints[k];
    if (joint.a != body && joint.b != body) continue;
    const std::int32_t other = joint.a == body ? joint.b : joint.a;
    const std::int32_t known = other < 0 ? -1 : place_of(m.model, other);
    if (known >= 0 && (known == 0 || m.model.bodies[idx(known)].is_solved)) continue;  // has it
    if (other >= 0 && add_body(m, other) < 0) return false;
    HandJoint added;
    static_cast<JointLaw&>(added) = joint;
    added.a = place_of(m.model, joint.a);
    added.b = joint.b < 0 ? -1 : place_of(m.model, joint.b);
    added.arm = m.world.joint_arm[k];
    added.impulse = m.step.joint_part[k];
    if (!m.model.joints.push_back(added)) return false;
  }
  return true;
}

/// The rows of a body with all that it touches but the one in the hand; false where there is no
/// room.
bool add_surroundings(const Making& m, std::int32_t place) noexcept {
  const std::int32_t body = m.model.bodies[idx(place)].body;
  // What is farther is not met in a step.
  constexpr double kSpare = 2.0;
  for (const NearPair* pair : m.step.pairs.near) {
    if (pair->first != body && pair->second != body) continue;
    const std::int32_t other = pair->first == body ? pair->second : pair->first;
    if (other == m.request.body || pair->model.rows.empty()) continue;
    const std::int32_t known = place_of(m.model, other);
    if (known >= 0 && has_pair(m.model, place, known)) continue;
    if (add_body(m, other) < 0) return false;
    const HandPair made = pair_of(m, *pair);
    const double most = made.slop + kSpare * (m.way(body) + m.way(other)) + m.model.room;
    if (!add_rows(m, *pair, made, most)) return false;
  }
  return add_joints(m, body);
}

/// Bodies next to the one in the hand, then those next to them, as long as there is room for all
/// that they touch: a body that is solved without what holds it would give way.
void solve_neighbours(const Making& m) noexcept {
  HandModel& model = m.model;
  int movers = 0;
  for (std::size_t i = 1; i < model.bodies.size() && movers < kHandMovers; ++i) {
    const std::int32_t body = model.bodies[i].body;
    const bool is_free = moves_freely(m.world.bodies[idx(body)].kind) &&
                         m.step.in_hand[idx(body)] == 0 && m.state.is_asleep[idx(body)] == 0;
    if (!is_free) continue;
    const std::size_t bodies = model.bodies.size(), pairs = model.pairs.size(),
                      rows = model.rows.size(), joints = model.joints.size();
    if (add_surroundings(m, static_cast<std::int32_t>(i))) {
      model.bodies[i].is_solved = true;
      ++movers;
      continue;
    }
    while (model.bodies.size() > bodies) model.bodies.pop_back();
    while (model.pairs.size() > pairs) model.pairs.pop_back();
    while (model.rows.size() > rows) model.rows.pop_back();
    while (model.joints.size() > joints) model.joints.pop_back();
    ++model.left_out;
  }
}

}  // namespace

void HandModelScratchDeleter::operator()(HandModelScratch* scratch) const noexcept {
  delete scratch;
}

HandModelScratchPtr reserve_hand_model(const World& world) {
  HandModelScratchPtr scratch(new HandModelScratch);
  detail::reserve_pairs(world, 2, scratch->pairs);
  scratch->near.reserve(world.bodies.size());
  scratch->touches.reserve(world.bodies.size());
  scratch->gaps.reserve(kMaxRows);
  return scratch;
}

void make_hand_model(const World& world, const WorldState& state, const WorldScratch& step,
                     const HandModelRequest& request, HandModelScratch& scratch, HandModel& model) {
  const Making m{world, state, step, request, scratch, model};
  model.bodies.clear();
  model.pairs.clear();
  model.rows.clear();
  model.joints.clear();
  model.left_out = 0;
  model.step = request.step;
  model.reach = m.reach(request.body);
  // Of the reach: as near as another body may always come before the next model.
  constexpr double kLeast = 0.01, kMost = 0.3;
  model.room = std::clamp(request.way, kLeast * model.reach, kMost * model.reach);
  add_body(m, request.body);
  model.bodies[0].is_solved = true;
  look_about(m, model.room);
  for (const HandModelScratch::Touch& touch : scratch.touches) add_touch(m, touch);
  if (!add_joints(m, request.body)) {
    ++model.left_out;
    model.room = 0.0;
  }
  solve_neighbours(m);
}

}  // namespace thigma
