#pragma once
// The front of the tandem traversal: which pairs of nodes were decided last time, and for how long
// that holds. Nodes are common; the exact and the multires query each keep lists of their own.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/contact.h"
#include "thigma/contact/resolution.h"
#include "thigma/convex/gjk.h"
#include "thigma/convex/patch_separation.h"

namespace thigma {

/// A node of the bounding volume test tree: a pair of hierarchy nodes. 64 bytes.
struct alignas(64) FrontNode {
  std::int32_t a = 0, b = 0;      // nodes of object and scene
  std::int32_t parent = -1;       // into ContactFront::nodes
  std::int32_t first_child = -1;  // -1: the pair is in the front
  std::int32_t next_sibling = -1;
  // leaf pairs: hull vertices of the closest features, 0 unknown
  std::uint32_t support_a = 0, support_b = 0;
  GjkCache gjk;
  // from a to b, unit or zero: separating, or the normal reported last [frame of a]
  float axis[3] = {0.0f, 0.0f, 0.0f};
  TriangleHint triangles;   // of patches whose triangles were measured
  bool has_normal = false;  // axis holds a contact normal (hysteresis)
  // Exact query: a leaf pair evaluated every frame, or a pair that could not be split for want of
  // room and is traversed below without memory.
  bool is_active = false, is_saturated = false;
  // Query with levels: what holds until the node's travel; apart covers culled and too far to
  // matter.
  enum class Decision : std::uint8_t { unknown, open, apart } decision = Decision::unknown;
};

static_assert(sizeof(FrontNode) == 64);

/// What the exact query keeps: places in ContactFront::nodes.
struct ExactFront {
  // leaf pairs measured every frame, by (object patch, scene patch)
  std::vector<std::int32_t> active, next_active, incoming;
  std::vector<std::int32_t> saturated;  // nodes traversed without memory
  std::vector<std::int64_t> stack;      // of that traversal
};

/// A pair of nodes a query with levels still has to look at, or may refine.
struct PendingPair {
  double priority = 0.0;  // s* / s0: larger first, where a budget decides
  double weight = 1.0;    // of everything below it
  // into ContactFront::nodes; -1: a and b tell the pair, without memory
  std::int32_t node = -1;
  std::int32_t a = 0, b = 0;
  std::int32_t contact = -1;  // its own in MultiresFront::found
};

/// What the query with levels of detail keeps beside the decisions of the nodes.
struct MultiresFront {
  std::vector<PendingPair> pending;  // stack of the traversal
  std::vector<PendingPair> queue;    // by priority, with a budget
  std::vector<Contact> found;        // contacts that may still be refined, with a budget
  std::vector<std::int32_t> order;   // of contacts
  // by node and SupportReading: largest D of the vertices of its patch, and the D of the patch
  // [m^2]
  std::vector<std::array<double, kSupportReadings>> object_support, scene_support;
  // CPU time of handing over one contact, measured; with a budget of time [s]
  double finish_cost = 0.0;
  double refine_cost = 0.0;  // the same of refining one pair, at most, of recent frames [s]
  // What the last query neither reported nor remembers as apart is no nearer than this; 0 unless
  // Resolution::exact_within was asked [m].
  double unremembered = 0.0;
};

/// A contact as it was measured, each side in the frame of its own body.
struct CarriedContact {
  Vec3 normal = Vec3::UnitZ();                    // [frame of a]
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();  // [m]
  double travel = 0.0, until = 0.0;               // of the front, then and at most [m]
  double bound = 0.0, nearest = 0.0;              // as of LevelPair [m]
  double growth = 1.0;  // how much more than the travel a depth along the normal may change
  LevelDecision decided_by = LevelDecision::finest;
  bool is_penetrating = false;
  bool is_of_hulls = false;  // hulls that are apart, and their distance: `nearest`
};

/// A pair that is certain to be within the tolerance, and has not been measured.
struct HeldPair {
  double least = 0.0;       // it may be as near as that [m]
  std::int32_t node = -1;   // into ContactFront::nodes
  std::size_t contact = 0;  // in the set
};

/// The contacts of a front that are carried: a place for each of its nodes, and the contacts, of
/// which fewer are enough. Empty until a query asks for it (Resolution::carry).
struct CarriedContacts {
  std::unique_ptr<std::int32_t[]> place;  // by node of the front, into `contacts`; -1: none
  std::vector<CarriedContact> contacts;
  std::vector<std::int32_t> free;  // places
  std::vector<HeldPair> held;      // of the last query
  double nearest = 0.0;            // of its contacts; where pairs are looked at more closely [m]
  Resolution asked;                // what they were measured for
  bool keeps_direction = false, measures_hulls = false;
};

/// Scratch of one pair of bodies. Owned by the caller, one a pair; any content is valid input.
///
/// Every node holds the travel up to which its decision stays true: a culled pair cannot come
/// within the tolerance, nor a split one leave it, before the bodies moved by its slack against
/// each other. So a frame looks only at pairs whose time has come, and at the contacts.
/// Memory is taken once, by reserve_front or the first query; when it is full, pairs are traversed
/// without memory. Thread: of the caller; not shared.
struct ContactFront {
  std::unique_ptr<FrontNode[]> nodes;
  // by node, on the scale of `travel`; infinity: never looked at [m]
  std::unique_ptr<float[]> expires;
  std::int32_t capacity = 0;          // nodes there is room for
  std::int32_t used = 0;              // nodes ever used
  std::int32_t free_head = -1;        // list of free nodes through next_sibling
  std::int32_t alive = 0, split = 0;  // nodes in use; of those, not in the front
  // relative motion since the origin of the scale, an upper bound [m]
  double travel = 0.0;
  double last_step = 0.0;        // of it, in the last query [m]
  double tolerance = -1.0;       // of the last query [m]; negative: nothing known
  RelativePose last;             // of the last query
  const void* object = nullptr;  // hierarchies of the last query, for comparison only
  const void* scene = nullptr;
  bool object_closed = true, scene_closed = true;  // see surface_crossing.h
  bool has_levels = false;         // the last query was one with levels: its decisions are others
  std::vector<std::int32_t> work;  // nodes to look at
  ExactFront exact;
  MultiresFront multires;
  CarriedContacts carried;
};

/// Nodes a front is given room for when the caller does not say.
std::int32_t default_front_capacity(const ClodHierarchy& object,
                                    const ClodHierarchy& scene) noexcept;

/// Takes the memory for a pair of hierarchies and forgets what was known.
/// capacity  nodes; 0 for default_front_capacity. 80 bytes each
/// Thread    [offline] or warm-up; throws std::bad_alloc.
void reserve_front(ContactFront& front, const ClodHierarchy& object, const ClodHierarchy& scene,
                   std::int32_t capacity = 0);

/// Takes the memory for contacts that are carried along (Resolution::carry) and forgets those it
/// has. A query that asks for it does so when there is none.
/// front   with memory
/// Thread  [offline] or warm-up; throws std::bad_alloc.
void reserve_carried(ContactFront& front);

/// Forgets coherence, keeps the memory.
/// Thread    [contact].
void clear_front(ContactFront& front) noexcept;

}  // namespace thigma
