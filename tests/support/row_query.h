#pragma once
// The contact side of the constrained response for one pair of bodies: query, then rows.

#include <memory>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/constraint/build_constraints.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::test {

/// An object and a body at rest in the world, with their rows.
struct RowQuery {
  TriangleMesh object, scene;
  ClodHierarchy object_tree, scene_tree;
  Friction friction{};
  LikelyWay way{};  // of the next questions
  ConstraintWorld world;
  std::vector<ContactFront> fronts;
  ContactSet contacts;
  ConstraintScratch scratch;
  std::unique_ptr<ConstraintModel> model = std::make_unique<ConstraintModel>();

  RowQuery(const TriangleMesh& a, const TriangleMesh& b, double friction_of_all = 0.0,
           std::size_t capacity = 16384)
      : object(a),
        scene(b),
        object_tree(build_exact_hierarchy(a)),
        scene_tree(build_exact_hierarchy(b)),
        friction{friction_of_all, friction_of_all} {
    const SceneBody body{&scene_tree, Pose{}};
    world = make_constraint_world(object_tree, Pose{}, {&body, 1});
    fronts.resize(1);
    reserve_front(fronts[0], object_tree, scene_tree);
    contacts.contacts.reserve(16384);
    reserve_constraints(world, capacity, scratch);
  }
  RowQuery(const RowQuery&) = delete;
  RowQuery& operator=(const RowQuery&) = delete;

  ConstraintStats ask(const BodyState& state, double tolerance, ConstraintModel& into) {
    ContactQuery query;
    query.tolerance = tolerance;
    query_scene({object_tree, {state.position, state.orientation}}, world.bodies, query, fronts,
                contacts);
    const bool is_free = contacts.contacts.empty();
    const double separation = is_free ? unreported_separation(fronts[0]) : tolerance;
    NearContacts near{contacts, separation};
    near.way = way;
    const ConstraintStats stats = build_constraints(world, state, near, scratch, into);
    for (ContactRow& row : into.rows) row.friction = friction;
    return stats;
  }
  ConstraintStats ask(const BodyState& state, double tolerance) {
    return ask(state, tolerance, *model);
  }
};

}  // namespace thigma::test
