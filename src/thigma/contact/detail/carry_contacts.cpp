#include "thigma/contact/detail/carry_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

// A contact keeps its normal, which turns with the object, and one point on each body. Travel m is
// the least of how far points of one body have moved in the frame of the other, step by step. So
//   the distance of two surfaces has changed by no more than m;
//   a turn is no more than m over the smaller radius R, and what is within l of the object has
//   moved in its frame by no more than m (1 + l / R);
//   the depth of two surfaces along the normal, or of the two points, has changed by no more than
//   that, with l the size of the scene's patch, or the distance of the points.
// The carried depth and the true one then differ by what they did and by twice that.
// What does change at once is the kind of a contact: from beside to through, and how far a pair
// that is turning from one to the other is. So a pair that is apart is carried only while it cannot
// touch, and if a front is what its closest points see; one that is through only while two of its
// triangles still pierce each other, as they did. A depth above the way alone would not do: patches
// slide out of each other sideways.

namespace thigma::detail {
namespace {

// Before any travel.
constexpr double kNotCarried = -1.0;

// Sine by which a front of two patches that are apart has to face the other.
constexpr double kFrontal = 0.25;

// Whether the direction, in the frame of the patch, lies before a real face that holds the feature.
bool is_before_front(const HullView& hull, std::uint32_t feature, const Vec3& direction) noexcept {
  for (int i = 0; i < hull.face_count; ++i) {
    if ((feature & ~hull.faces[i].vertices) != 0) continue;
    if (hull.faces[i].normal.dot(direction) > kFrontal) return true;
  }
  return false;
}

using Corners = std::array<Vec3, 3>;

// Six times the volume of a tetrahedron.
double volume(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) noexcept {
  return (q - p).cross(r - p).dot(s - p);
}

// Whether an edge of one triangle runs through the other, by more than rounding.
bool runs_through(const Corners& edges, const Corners& t, double rounding) noexcept {
  double height[3];
  for (int i = 0; i < 3; ++i) height[i] = volume(t[0], t[1], t[2], edges[i]);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const bool crosses_plane = (height[i] > rounding && height[j] < -rounding) ||
                               (height[i] < -rounding && height[j] > rounding);
    if (!crosses_plane) continue;
    const double u = volume(edges[i], edges[j], t[0], t[1]);
    const double v = volume(edges[i], edges[j], t[1], t[2]);
    const double w = volume(edges[i], edges[j], t[2], t[0]);
    if (std::min({u, v, w}) > rounding || std::max({u, v, w}) < -rounding) return true;
  }
  return false;
}

// Whether the two triangles that pierced each other when they were measured still do. False where
// that is not certain.
bool still_pierce(const HullView& a, const HullView& b, const RelativePose& a_from_b,
                  const TriangleHint& hint) noexcept {
  constexpr double kRounding = 1e-11;  // of volumes, times the cube of the size
  if (!hint.meet || hint.a >= a.triangle_count || hint.b >= b.triangle_count) return false;
  Corners of_a, of_b;
  const Vec3 offset = a_from_b.rotation * b.center + a_from_b.translation - a.center;
  for (int k = 0; k < 3; ++k) {
    of_a[k] = a.vertices[a.triangles[hint.a].corner[k]] - a.center;
    of_b[k] = a_from_b.rotation * (b.vertices[b.triangles[hint.b].corner[k]] - b.center) + offset;
  }
  const double size = a.radius + b.radius;
  const double rounding = kRounding * size * size * size;
  return runs_through(of_a, of_b, rounding) || runs_through(of_b, of_a, rounding);
}

// How far the bodies may move before a pair could be of another kind; 0: not at all. Hulls that are
// apart have no back.
double steadiness(const PatchPair& pair, const HullView& a, const HullView& b,
                  const RelativePose& a_from_b, bool is_of_hulls) noexcept {
  if (pair.status == PairContactStatus::separated) {
    if (is_of_hulls) return pair.separation;
    const Vec3 back = -(a_from_b.rotation.transpose() * pair.normal);
    const bool faces =
        is_before_front(a, pair.feature_a, pair.normal) || is_before_front(b, pair.feature_b, back);
    return faces ? pair.separation : 0.0;
  }
  const bool is_through = pair.status == PairContactStatus::penetrating && pair.separation == 0.0;
  return is_through ? pair.depth : 0.0;
}

// Not all at once: between half of the way and all of it, by the place in the front.
double share_of(std::int32_t i) noexcept {
  const std::uint32_t mixed = (static_cast<std::uint32_t>(i) * 2654435761u) >> 24;
  return 0.5 + 0.5 * static_cast<double>(mixed) / 255.0;
}

// See above.
double growth_apart(const QueryFrame& frame) noexcept {
  return 1.0 + frame.query.tolerance / std::min(frame.object.radius, frame.scene.radius);
}

double growth_of(const QueryFrame& frame, std::int32_t i, bool is_penetrating) noexcept {
  if (!is_penetrating) return growth_apart(frame);
  const ClodNode& b = node_b(frame, frame.front.nodes[i].b);
  return 1.0 + 2.0 * (b.radius + b.hausdorff) / std::min(frame.object.radius, frame.scene.radius);
}

bool is_same_question(const Resolution& x, const Resolution& y) noexcept {
  return x.metric.haptic == y.metric.haptic && x.deviation_cap == y.deviation_cap &&
         x.coarsest_level == y.coarsest_level && x.reading == y.reading && x.area == y.area &&
         x.interpolates == y.interpolates && x.carry == y.carry;
}

}  // namespace

void forget_carried(ContactFront& front) noexcept {
  CarriedContacts& carried = front.carried;
  if (carried.place == nullptr) return;
  std::fill_n(carried.place.get(), front.used, -1);
  carried.free.clear();
  // the first place on top
  for (auto i = static_cast<std::int32_t>(carried.contacts.size()); i > 0; --i)
    carried.free.push_back(i - 1);
}

void forget_depths(ContactFront& front) noexcept {
  CarriedContacts& carried = front.carried;
  if (carried.place == nullptr) return;
  for (std::int32_t i = 0; i < front.used; ++i) {
    if (carried.place[i] < 0) continue;
    CarriedContact& contact = carried.contacts[static_cast<std::size_t>(carried.place[i])];
    contact.until = kNotCarried;
    if (!contact.is_of_hulls) drop_carried(carried, i);
  }
}

bool is_carrying(QueryFrame& frame) noexcept {
  const Resolution& r = frame.query.resolution;
  CarriedContacts& carried = frame.front.carried;
  const bool is_of_pose = r.metric.velocity > 0.0 || r.metric.view.pixels > 0.0;
  const bool has_budget = r.budget_tests > 0 || r.budget_cpu > 0.0;
  if (!(r.carry > 0.0) || carried.place == nullptr) return false;
  if (!r.is_exact && (is_of_pose || has_budget || r.exact_within > 0.0)) return false;
  if (!is_same_question(carried.asked, r) ||
      carried.keeps_direction != frame.query.keep_directions ||
      carried.measures_hulls != frame.query.measures_hulls) {
    forget_carried(frame.front);
    carried.asked = r;
    carried.keeps_direction = frame.query.keep_directions;
    carried.measures_hulls = frame.query.measures_hulls;
  }
  return true;
}

void keep_contact(QueryFrame& frame, std::int32_t i, const HullView& a, const HullView& b,
                  const MeasuredContact& measured) noexcept {
  CarriedContacts& carried = frame.front.carried;
  const double most = share_of(i) * frame.query.resolution.carry * frame.query.tolerance;
  const bool is_steady = !measured.is_of_search && steadiness(measured.pair, a, b, frame.pose,
                                                              frame.query.measures_hulls) > most;
  const bool is_of_hulls =
      measured.pair.status == PairContactStatus::separated && measured.pair.is_of_hulls;
  if (!is_steady && !(is_of_hulls && frame.query.holds_near)) return drop_carried(carried, i);
  if (carried.place[i] < 0) {
    if (carried.free.empty()) return;
    carried.place[i] = carried.free.back();
    carried.free.pop_back();
  }
  const PatchPair& pair = measured.pair;
  CarriedContact& contact = carried.contacts[static_cast<std::size_t>(carried.place[i])];
  contact.normal = pair.normal;
  contact.on_a = pair.witness_a;
  contact.on_b = frame.pose.rotation.transpose() * (pair.witness_b - frame.pose.translation);
  contact.travel = frame.front.travel;
  contact.until = is_steady ? frame.front.travel + most : kNotCarried;
  contact.bound = measured.bound;
  contact.nearest = measured.nearest;
  contact.decided_by = measured.decided_by;
  contact.is_penetrating = pair.status == PairContactStatus::penetrating;
  contact.is_of_hulls = is_of_hulls;
  contact.growth = growth_of(frame, i, contact.is_penetrating);
}

void move_contact(const QueryFrame& frame, const CarriedContact& contact,
                  MeasuredContact& out) noexcept {
  // Of the points along the normal, times the size of the pair.
  constexpr double kRounding = 1e-12;
  // The points may be farther from each other now than the tolerance was then.
  const double growth =
      contact.is_penetrating ? contact.growth : std::max(contact.growth, growth_apart(frame));
  const double moved = growth * (frame.front.travel - contact.travel);
  PatchPair& pair = out.pair;
  pair.status =
      contact.is_penetrating ? PairContactStatus::penetrating : PairContactStatus::separated;
  pair.normal = contact.normal;
  pair.witness_a = contact.on_a;
  pair.witness_b = frame.pose.rotation * contact.on_b + frame.pose.translation;
  pair.depth = pair.normal.dot(pair.witness_a - pair.witness_b);
  pair.separation = std::max(-pair.depth, 0.0);
  // The contract of a contact: its points differ along the normal alone.
  const Vec3 middle = 0.5 * (pair.witness_a + pair.witness_b);
  pair.witness_a = middle + 0.5 * pair.depth * pair.normal;
  pair.witness_b = middle - 0.5 * pair.depth * pair.normal;
  out.bound = contact.bound + 2.0 * moved + kRounding * (frame.object.radius + frame.scene.radius);
  out.nearest = contact.nearest - moved;
  out.decided_by = contact.decided_by;
}

bool carry_contact(const QueryFrame& frame, const FrontNode& node, std::int32_t i,
                   MeasuredContact& out) noexcept {
  const CarriedContacts& carried = frame.front.carried;
  if (!has_carried(carried, i)) return false;
  const CarriedContact& contact = carried_of(carried, i);
  if (frame.front.travel > contact.until) return false;
  if (contact.is_penetrating &&
      !still_pierce(level_surface(frame.object, node.a), level_surface(frame.scene, node.b),
                    frame.pose, node.triangles))
    return false;
  move_contact(frame, contact, out);
  return true;
}

}  // namespace thigma::detail
