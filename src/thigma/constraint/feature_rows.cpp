#include "thigma/constraint/feature_rows.h"

#include <algorithm>

#include "thigma/constraint/detail/pair_lists.h"
#include "thigma/constraint/detail/plane_choice.h"
#include "thigma/constraint/detail/row_search.h"
#include "thigma/core/index.h"

namespace thigma {
namespace {

/// A contact of this body at the finest level; others have no features.
bool has_features(const BodyPair& pair, const Contact& contact) noexcept {
  const auto is_finest = [](const SurfaceFeatures& features, std::int32_t patch) {
    return patch >= 0 && idx(patch) + 1 < features.first_vertex.size();
  };
  return contact.body == pair.body && is_finest(*pair.object.features, contact.object_patch) &&
         is_finest(*pair.scene.features, contact.scene_patch);
}

void empty(VertexSide& side) noexcept {
  for (const std::int32_t vertex : side.touched) side.first_member[idx(vertex)] = -1;
  side.touched.clear();
  side.candidates.clear();
  side.planes.clear();
  side.members.clear();
}

void reserve_side(VertexSide& side, std::size_t vertices, std::size_t capacity) {
  if (side.first_member.size() < vertices) side.first_member.resize(vertices, -1);
  side.touched.reserve(std::max(side.touched.capacity(), vertices));
  side.candidates.reserve(capacity);
  side.planes.reserve(capacity);
  side.members.reserve(capacity);
}

}  // namespace

void reserve_rows(RowScratch& scratch, const SurfaceFeatures& object, const SurfaceFeatures& scene,
                  std::size_t capacity) {
  reserve_side(scratch.object, object.vertices.size(), capacity);
  reserve_side(scratch.scene, scene.vertices.size(), capacity);
  scratch.met.reserve(capacity);
  scratch.slabs.reserve(capacity);
  scratch.planes.reserve(capacity);
  scratch.near_edges.reserve(capacity);
  scratch.near_cones.reserve(capacity);
  scratch.listed.reserve(capacity);
  scratch.near_object.reserve(detail::kMostNear);
  scratch.near_scene.reserve(detail::kMostNear);
}

void reserve_pair_lists(RowScratch& scratch) {
  constexpr std::size_t kLists = 8192;  // eight times the contacts of a busy frame
  scratch.lists.resize(kLists);
}

std::int64_t find_rows(const BodyPair& pair, std::span<const Contact> contacts,
                       const RowReach& reach, RowScratch& scratch,
                       std::vector<FoundRow>& rows) noexcept {
  detail::RowSearch search = detail::make_search(pair, reach);
  detail::find_known(contacts, search);
  empty(scratch.object);
  empty(scratch.scene);
  scratch.met.clear();
  detail::begin_lists(contacts.size(), scratch);
  scratch.slabs.clear();
  for (const Contact& contact : contacts) {
    if (!has_features(pair, contact)) continue;
    if (scratch.slabs.size() == scratch.slabs.capacity()) {
      ++search.left_out;
      break;
    }
    scratch.slabs.push_back(detail::gather_vertices(search, contact, scratch));
  }
  detail::search_vertices(search, scratch, rows);
  std::size_t next = 0;
  for (const Contact& contact : contacts) {
    if (next == scratch.slabs.size()) break;
    if (!has_features(pair, contact)) continue;
    if (reach.most_rows > 0 && rows.size() > reach.most_rows) {
      ++search.left_out;
      break;
    }
    detail::search_edges(search, contact, scratch.slabs[next++], scratch, rows);
  }
  return search.left_out;
}

}  // namespace thigma
