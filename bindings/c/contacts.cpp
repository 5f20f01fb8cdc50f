// Contacts from frame to frame.

#include "contact_table.h"
#include "guard.h"
#include "handles.h"

#include "thigma/core/error.h"

namespace {

using namespace thigma;

void put(const Vec3& v, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = v[i];
}

void put(const Contact& from, thigma_contact& to) {
  put(from.point, to.point);
  put(from.scene_point, to.scene_point);
  put(from.normal, to.normal);
  to.depth = from.depth;
  to.bound = from.bound;
  to.object_level = from.object_level;
  to.scene_level = from.scene_level;
}

ContactQuery query_from(const thigma_query& given) {
  ContactQuery query;
  query.tolerance = given.tolerance;
  query.resolution.is_exact = given.is_exact != 0;
  query.resolution.metric.haptic = given.threshold;
  query.resolution.budget_tests = given.budget_tests;
  query.resolution.step_time = given.step_time;
  bindings::check_query(query);
  return query;
}

}  // namespace

extern "C" {

void thigma_query_init(thigma_query* query) {
  if (query != nullptr) *query = {sizeof(thigma_query), 1, 0.0, 0.025, 0, 0.001};
}

thigma_result thigma_tracker_create(const thigma_clod* object, const thigma_clod* scene,
                                    const double* scene_pose, const thigma_query* query,
                                    thigma_tracker** tracker) {
  return c::guarded([&] {
    c::needed(tracker, "tracker");
    auto made = std::make_unique<thigma_tracker>();
    made->object = c::needed(object, "object").asset;
    made->scene = c::needed(scene, "scene").asset;
    if (scene_pose != nullptr) made->scene_pose = c::pose_from(scene_pose, "scene_pose");
    made->query = query_from(c::sized(query, "query"));
    for (const auto* side : {made->object.get(), made->scene.get()})
      if (!made->query.resolution.is_exact && side->meshes.empty())
        throw InputError("tracker: without levels of detail, expected those of thigma_clod_build");
    reserve_front(made->front, made->object->hierarchy, made->scene->hierarchy);
    made->found.contacts.reserve(1024);
    *tracker = made.release();
  });
}

void thigma_tracker_free(thigma_tracker* tracker) { delete tracker; }

thigma_result thigma_tracker_contacts(thigma_tracker* tracker, const double* pose,
                                      thigma_contact* contacts, int64_t capacity, int64_t* count,
                                      double* distance) {
  return c::guarded([&] {
    thigma_tracker& t = c::needed(tracker, "tracker");
    c::needed(count, "count");
    if (capacity < 0) throw std::invalid_argument("capacity: below 0");
    if (capacity > 0) c::needed(contacts, "contacts");
    const PlacedHierarchy object{t.object->hierarchy, c::pose_from(pose, "pose")};
    do {
      clear(t.found);
      query_contacts(object, {t.scene->hierarchy, t.scene_pose}, t.query, t.front, t.found);
    } while (bindings::needs_room(t.found, 0));
    const auto found = static_cast<int64_t>(t.found.contacts.size());
    for (int64_t i = 0; i < std::min(found, capacity); ++i)
      put(t.found.contacts[static_cast<std::size_t>(i)], contacts[i]);
    *count = found;
    if (distance != nullptr) *distance = least_distance(t.found);
  });
}

}  // extern "C"
