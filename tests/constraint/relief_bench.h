#pragma once
// Two slabs with a round hill each, one upside down over the other: relief rows of one peak.

#include "thigma/clod/build_hierarchy.h"
#include "thigma/constraint/relief_rows.h"
#include "thigma/math/rotation.h"
#include "thigma/models/textured_model.h"

namespace thigma::test {

struct ReliefBench {
  static HapticTexture hill(double curvature) {
    return make_texture(models::make_textured_slab({{0.02, 0.02, 0.01},
                                                    257,
                                                    [=](double x, double y) {
                                                      return -0.5 * curvature * (x * x + y * y);
                                                    }}),
                        "hill");
  }

  HapticTexture object, scene;
  ClodHierarchy object_tree = build_exact_hierarchy(object.coarse),
                scene_tree = build_exact_hierarchy(scene.coarse);
  SceneBody body{&scene_tree, Pose{}};
  // of the object's mesh in its body frame: upside down, 0.1 mm above the other
  Pose body_from_mesh{Vec3(4e-4, -7e-4, 0.0101), rotation_from_vector({0.0, 3.14159265, 0.0})};
  TexturedWorld world;
  ReliefPatches patches;
  std::vector<ContactFront> fronts{1};
  ContactSet contacts;
  ReliefScratch scratch;

  /// Curvatures of the hills [1/m].
  explicit ReliefBench(double of_object = 20.0, double of_scene = 30.0)
      : object(hill(of_object)), scene(hill(of_scene)) {
    world.object = make_textured_body(object, object_tree);
    world.scene = {make_textured_body(scene, scene_tree)};
    patches = find_relief_patches(world);
    reserve_front(fronts[0], object_tree, scene_tree);
    contacts.contacts.reserve(64);
    reserve_relief(world, 64, scratch);
  }
  ReliefBench(const ReliefBench&) = delete;
  ReliefBench& operator=(const ReliefBench&) = delete;

  /// Rows of given contacts; object points in the body frame.
  void ask_about(const ContactSet& given, const Pose& world_from_body, double travel) {
    constexpr double kReach = 0.015;
    find_relief_rows({world, patches, {&body, 1}, given, 5, travel},
                     world_from_body * body_from_mesh, world_from_body.position,
                     {travel, travel / kReach, 1e-6}, scratch);
    for (FoundRow& row : scratch.rows)
      row.row.object_point = transform_point(body_from_mesh, row.row.object_point);
  }
  void ask(const Pose& world_from_body, double travel) {
    ContactQuery query;
    query.tolerance = travel + relief_of(world);
    query_scene({object_tree, world_from_body * body_from_mesh}, {&body, 1}, query, fronts,
                contacts);
    ask_about(contacts, world_from_body, travel);
  }
};

}  // namespace thigma::test
