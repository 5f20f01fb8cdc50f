#include "thigma/constraint/detail/pair_lists.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

using PairList = RowScratch::PairList;

// Of the travel: for how much more features are listed at most. More makes lists long, less makes
// them again and again.
constexpr double kMargin = 1.0;

bool is_of(const PairList& list, const RowSearch& search, const Contact& contact) noexcept {
  return list.object_patch == contact.object_patch && list.scene_patch == contact.scene_patch &&
         list.body == search.body && list.object == search.object.features &&
         list.scene == search.scene.features;
}

/// Of a pair of patches, the same in every run.
std::uint64_t hash_of(const RowSearch& search, const Contact& contact) noexcept {
  return id_of(search, RowKind::scene_plane, contact.object_patch, contact.scene_patch);
}

Vec3 placed_center(const RowSearch& search, const Contact& contact) noexcept {
  const PatchBall& ball = search.object.features->patch_balls[idx(contact.object_patch)];
  return transform_point(search.scene_from_object, ball.center);
}

/// Whether no point of the object's patch has moved, nor a direction turned, by more than the list
/// was made for.
bool holds(const PairList& list, const RowSearch& search, const Contact& contact) noexcept {
  const double radius = search.object.features->patch_balls[idx(contact.object_patch)].radius;
  const Quat turned = list.scene_from_object.conjugate() * search.scene_from_object.orientation;
  const double chord = 2.0 * turned.vec().norm();  // of a unit vector's tip, at most
  const double moved = (placed_center(search, contact) - list.center).norm() + chord * radius;
  // A cross product of two edges turns with both of them, and its scalar product with a third.
  return search.reach.travel + moved + search.rounding <= list.travel &&
         search.cone_slack + 3.0 * chord <= list.slack;
}

/// Whether a list would hold for some frames: it takes as long to make as two or three searches.
/// The likely way is of two models.
bool outlives_frames(const RowSearch& search) noexcept {
  constexpr double kModels = 2.0, kFrames = 4.0;
  if (!search.reach.way.is_known) return true;
  return kFrames * length_of_way(search.reach) / kModels <= kMargin * search.reach.travel;
}

/// Some lists are made for less, so that not all end in one frame.
PairReach kept_reach(const RowSearch& search, std::uint64_t hash) noexcept {
  constexpr double kLeast = 0.5, kBits = 1.0 / 256.0;
  const double share = kLeast + (1.0 - kLeast) * kBits * static_cast<double>(hash >> 56);
  const double margin = kMargin * share;
  return {(1.0 + margin) * search.reach.travel,
          search.cone_slack + 3.0 * margin * search.reach.turn, true};
}

void make_list(RowSearch& search, const Contact& contact, const PairReach& reach,
               RowScratch& scratch, PairList& list) noexcept {
  list.object = search.object.features;
  list.scene = search.scene.features;
  list.body = search.body;
  list.object_patch = contact.object_patch;
  list.scene_patch = contact.scene_patch;
  list.center = placed_center(search, contact);
  list.scene_from_object = search.scene_from_object.orientation;
  list.travel = reach.travel;
  list.slack = reach.slack;
  // The place may have been of two other patches, and found to hold in this call.
  list.checked = -1;
  const Slab slab = find_slab(search, contact, reach.travel);
  const std::int64_t left_out = search.left_out;
  std::array<std::size_t, 3> ends{};
  scratch.listed.clear();
  list_vertices(search, FeatureKind::object_vertices, contact, slab, reach, scratch);
  ends[0] = scratch.listed.size();
  list_vertices(search, FeatureKind::scene_vertices, contact, slab, reach, scratch);
  ends[1] = scratch.listed.size();
  if (gather_edges(search, contact, slab, reach, scratch))
    list_edges(search, contact, slab, reach, {}, scratch);
  ends[2] = scratch.listed.size();
  list.is_full = search.left_out > left_out || ends[2] > list.pairs.size();
  search.left_out = left_out;  // what is not listed is searched as without lists
  if (list.is_full) return;
  std::copy(scratch.listed.begin(), scratch.listed.end(), list.pairs.begin());
  for (std::size_t k = 0; k < ends.size(); ++k) list.ends[k] = static_cast<std::uint8_t>(ends[k]);
}

}  // namespace

PairReach exact_reach(const RowSearch& search) noexcept {
  return {search.reach.travel, search.cone_slack, false};
}

void begin_lists(std::size_t contacts, RowScratch& scratch) noexcept {
  constexpr std::int64_t kLeast = 2, kShare = 8;
  ++scratch.calls;
  scratch.most_made = scratch.lists_made + kLeast + static_cast<std::int64_t>(contacts) / kShare;
}

const PairList* find_list(const RowSearch& search, const Contact& contact,
                          const RowScratch& scratch) noexcept {
  if (scratch.lists.empty()) return nullptr;
  const PairList& list = scratch.lists[hash_of(search, contact) % scratch.lists.size()];
  return list.checked == scratch.calls && is_of(list, search, contact) ? &list : nullptr;
}

const PairList* keep_list(RowSearch& search, const Contact& contact, RowScratch& scratch) noexcept {
  if (scratch.lists.empty()) return nullptr;
  const std::uint64_t hash = hash_of(search, contact);
  PairList& list = scratch.lists[hash % scratch.lists.size()];
  if (is_of(list, search, contact) && holds(list, search, contact)) {
    ++scratch.lists_used;
  } else {
    if (scratch.lists_made == scratch.most_made || !outlives_frames(search)) return nullptr;
    make_list(search, contact, kept_reach(search, hash), scratch, list);
    ++scratch.lists_made;
  }
  if (list.is_full) return nullptr;
  list.checked = scratch.calls;
  return &list;
}

std::span<const RowScratch::FeaturePair> pairs_of(const PairList& list, FeatureKind kind) noexcept {
  const auto k = static_cast<std::size_t>(kind);
  const std::size_t begin = k == 0 ? 0 : list.ends[k - 1];
  return {list.pairs.data() + begin, list.ends[k] - begin};
}

}  // namespace thigma::detail
