#pragma once
// Texture forces in the contact model: where a cluster touches relief, its depth and gradient come
// from the textures (Sec. 4.2.2, 5.4.4).

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "thigma/contact/clustering.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/depth/depth_gradient.h"
#include "thigma/depth/triangle_ring.h"
#include "thigma/dynamics/linear_contact_model.h"
#include "thigma/response/linearize_contacts.h"
#include "thigma/response/penalty.h"
#include "thigma/response/textured_world.h"

namespace thigma {

/// A body at full resolution.
/// Thread [offline].
TexturedBody make_textured_body(const HapticTexture& texture, const ClodHierarchy& hierarchy);

/// A body with levels of detail: one texture for each level that is not free.
/// Thread [offline].
TexturedBody make_textured_levels(std::vector<const HapticTexture*> textures,
                                  const ClodHierarchy& hierarchy);

/// Whether contacts of any level can be refined; otherwise queries have to be exact.
bool has_levels(const TexturedWorld& world) noexcept;

/// Whether a contact with this body of the scene touches relief.
inline bool is_textured(const TexturedWorld& world, std::int32_t body) noexcept {
  return world.object.has_relief ||
         (body >= 0 && world.scene[static_cast<std::size_t>(body)].has_relief);
}

/// By how much fine surfaces may meet before those of level 0 come within a tolerance: what a query
/// has to add [m].
double relief_of(const TexturedWorld& world) noexcept;

/// After a query at tolerance + relief_of(world): takes out contacts that neither relief of their
/// own two bodies nor what their levels leave open (`bound`) makes real, and makes the others weigh
/// in clusters by depth + tolerance + both, so that plain ones weigh what they do without textures.
///
/// tolerance  without relief [m]
/// contacts   order of those that stay is kept; depth below the reach of the query is raised to it
/// Thread     [contact]; no failure.
void limit_to_relief(const TexturedWorld& world, double tolerance, ContactSet& contacts) noexcept;

/// Working memory. Any content is valid; the backend is made by reserve_texture_scratch.
struct TextureScratch {
  std::unique_ptr<DepthBackend> backend;
  std::vector<DepthContact> contacts;                                        // of the last frame
  std::vector<DepthSamples> samples;                                         // of them
  std::vector<std::vector<std::int32_t>> object_triangles, scene_triangles;  // one a depth contact
  // the triangles beside those
  std::vector<std::vector<std::int32_t>> object_around, scene_around;
  TriangleMarks object_marks, scene_marks;
  std::vector<std::int32_t> cluster, body;  // of each depth contact
  std::int64_t left_out = 0;                // that there was no room for
  std::vector<double> deepest;  // that a member of each depth contact may be, relief left aside [m]
  GradientScratch gradient;
  ContactClusters plain;  // those that touch no relief
};

/// Room for the largest contacts there can be. A graphics processor is opened and sent every
/// texture of the world, so that the first frame is like any other; its driver may allocate in any
/// frame. Thread [offline]; throws std::bad_alloc.
void reserve_texture_scratch(const TexturedWorld& world, TextureScratch& scratch);

/// The same without what looks for depths.
void reserve_depth_contacts(const TexturedWorld& world, TextureScratch& scratch);

/// The contacts of a frame on a textured world.
struct TexturedContacts {
  const TexturedWorld& world;  // not empty
  Pose world_from_object;      // of the object's mesh
  std::span<const SceneBody> bodies;
  // as clustered. The triangles of a cluster are those of the coarsest level among its members,
  // where the finer ones lie below; what it feels is the fine surface at any level, within the fit
  // of its texture
  std::span<const Contact> contacts;
  const ContactClusters& clusters;
  std::span<const std::int32_t> assignment;  // of cluster_contacts
};

/// Depth contacts of the clusters that touch relief, one a body, about a centre [m; world]: into
/// scratch.contacts, with cluster, body and deepest of each. Other clusters go to scratch.plain.
/// Thread  [contact]; no failure.
void find_depth_contacts(const TexturedContacts& touching, const Vec3& centre,
                         TextureScratch& scratch) noexcept;

/// Contact model of one frame: a depth term for each cluster and textured body it touches, plane
/// terms for the others; all share the stiffness by depth + tolerance.
///
/// penalty, stamp  as linearize_contacts
/// scratch         results of the last call are looked into by tests and reports
/// returns         depth terms without depth, because the surfaces share no part of the plane along
///                 n, are left out; a depth above what coarse depth, relief and tolerance allow
///                 together is cut to it
/// Thread          [contact]; no failure; allocates only when a contact is larger than any before.
/// Source          Sec. 4.2.2, 5.4.4, Eq. 5.56. Deviates: D79, D81.
LinearContactModel linearize_textured(const TexturedContacts& touching,
                                      const PenaltyParams& penalty, const ModelStamp& stamp,
                                      TextureScratch& scratch) noexcept;

}  // namespace thigma
