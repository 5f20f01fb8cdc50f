// A cluster is one contact of Sec. 4.2.2: the triangles of its members' patches on either side, its mean normal, its
// centre. Members of one cluster may belong to several bodies; each body has a texture of its own and so a term.
#include "thigma/response/texture_contacts.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/response/linearize_contacts.h"
#include "thigma/texture/gpu_depth.h"

namespace thigma {
namespace {

/// Adds the triangles of a finest patch that are not there yet.
void add_triangles(const ClodHierarchy& hierarchy, std::int32_t patch, std::uint32_t round,
                   std::vector<std::uint32_t>& marks,
                   std::vector<std::int32_t>& triangles) noexcept {
  if (patch < 0 || at(patch) >= hierarchy.patches.size()) return;
  const ClodPatch& p = hierarchy.patches[at(patch)];
  for (std::int32_t i = p.first_triangle; i < p.first_triangle + p.triangle_count; ++i) {
    const std::int32_t t = hierarchy.triangle_ids[at(i)];
    if (marks[at(t)] == round) continue;
    marks[at(t)] = round;
    triangles.push_back(t);
  }
}

/// The object, and a body of the scene, as one cluster touches them. False without such members.
bool gather(const TexturedWorld& world, std::span<const Contact> contacts,
            std::span<const std::int32_t> assignment, std::int32_t cluster, std::int32_t body,
            std::size_t slot, TextureScratch& scratch) noexcept {
  if (++scratch.round == 0) {  // after 2^32 of them: no mark may look new
    std::fill(scratch.object_marks.begin(), scratch.object_marks.end(), 0u);
    std::fill(scratch.scene_marks.begin(), scratch.scene_marks.end(), 0u);
    scratch.round = 1;
  }
  const std::uint32_t round = scratch.round;
  std::vector<std::int32_t>&of_object = scratch.object_triangles[slot],
  &of_scene = scratch.scene_triangles[slot];
  of_object.clear();
  of_scene.clear();
  double deepest = kNoDepth;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    if (assignment[i] != cluster || contact.body != body) continue;
    add_triangles(*world.object.hierarchy, contact.object_patch, round, scratch.object_marks,
                  of_object);
    add_triangles(*world.scene[at(body)].hierarchy, contact.scene_patch, round, scratch.scene_marks,
                  of_scene);
    deepest = std::max(deepest, contact.depth);
  }
  // Clusters name their members in the order of contacts, which may change while the triangles do not.
  std::sort(of_object.begin(), of_object.end());
  std::sort(of_scene.begin(), of_scene.end());
  scratch.deepest[slot] = deepest;
  return !of_object.empty() && !of_scene.empty();
}

bool touches_relief(const TexturedWorld& world, std::span<const Contact> contacts,
                    std::span<const std::int32_t> assignment, std::int32_t cluster) noexcept {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (assignment[i] == cluster && is_textured(world, contacts[i].body)) return true;
  return false;
}

/// Depth contacts of the clusters that touch relief; the other clusters go to scratch.plain.
void divide(const TexturedWorld& world, const Pose& world_from_object,
            std::span<const SceneBody> bodies, std::span<const Contact> contacts,
            const ContactClusters& clusters, std::span<const std::int32_t> assignment,
            const Vec3& centre, TextureScratch& scratch) noexcept {
  scratch.contacts.clear();
  scratch.cluster.clear();
  scratch.body.clear();
  scratch.plain = clusters;
  scratch.plain.clusters.clear();
  for (std::size_t c = 0; c < clusters.clusters.size(); ++c) {
    const ContactCluster& cluster = clusters.clusters[c];
    const std::int32_t index = static_cast<std::int32_t>(c);
    if (!touches_relief(world, contacts, assignment, index)) {
      scratch.plain.clusters.push_back(cluster);
      continue;
    }
    for (std::size_t b = 0; b < world.scene.size(); ++b) {
      const std::size_t slot = scratch.contacts.size();
      if (slot == scratch.object_triangles.size()) break;  // as many as the model has room for
      const std::int32_t body = static_cast<std::int32_t>(b);
      if (!gather(world, contacts, assignment, index, body, slot, scratch)) continue;
      DepthContact contact;
      contact.object = {world.object.texture, scratch.object_triangles[slot], world_from_object};
      contact.scene = {world.scene[b].texture, scratch.scene_triangles[slot],
                       bodies[b].world_from_body};
      contact.point = cluster.point;
      contact.normal = cluster.normal;
      contact.centre = centre;
      scratch.contacts.push_back(contact);
      scratch.cluster.push_back(index);
      scratch.body.push_back(body);
    }
  }
}

std::unique_ptr<DepthBackend> open_gpu_search(const TexturedWorld& world) {
  GpuDepthParams params;
  params.grid.resolution = world.params.resolution;
  params.warn = world.warn;
  params.textures.push_back(world.object.texture);
  for (const TexturedBody& body : world.scene) params.textures.push_back(body.texture);
  GpuDepth gpu = make_gpu_depth(params);
  if (gpu.is_on_gpu && gpu.is_software && world.warn)
    world.warn("textures are computed by " + gpu.renderer +
               ", in software: slower than depth = \"grid\"");
  return std::move(gpu.backend);
}

std::unique_ptr<DepthBackend> open_search(const TexturedWorld& world) {
  switch (world.params.search) {
    case DepthSearch::branch:
      return make_branch_depth({.max_nodes = world.params.max_nodes});
    case DepthSearch::gpu:
      return open_gpu_search(world);
    case DepthSearch::grid:
      break;
  }
  return make_grid_depth({.resolution = world.params.resolution});
}

double amplitude_of(const DepthContact& contact) noexcept {
  return contact.object.texture->amplitude + contact.scene.texture->amplitude;
}

}  // namespace

TexturedBody make_textured_body(const HapticTexture& texture, const ClodHierarchy& hierarchy) {
  TexturedBody body{&texture, &hierarchy, 0.0};
  for (const Texel& t : texture.texels)
    body.relief = std::max(
        body.relief,
        Vec3(static_cast<double>(t.x), static_cast<double>(t.y), static_cast<double>(t.z)).norm());
  return body;
}

double relief_of(const TexturedWorld& world) noexcept {
  if (world.is_empty()) return 0.0;
  double most = 0.0;
  for (const TexturedBody& body : world.scene) most = std::max(most, body.relief);
  return world.object.relief + most;
}

void limit_to_relief(const TexturedWorld& world, double tolerance, ContactSet& contacts) noexcept {
  const double most = tolerance + relief_of(world);
  const auto own_reach = [&](const Contact& contact) {
    const double relief = contact.body >= 0 ? world.scene[at(contact.body)].relief : 0.0;
    return contact.depth + tolerance + world.object.relief + relief;
  };
  contacts.contacts.erase(
      std::remove_if(contacts.contacts.begin(), contacts.contacts.end(),
                     [&](const Contact& contact) { return own_reach(contact) < 0.0; }),
      contacts.contacts.end());
  for (Contact& contact : contacts.contacts) {
    const double reach = contact.depth + most;
    if (reach > 0.0) contact.weight = own_reach(contact) / reach;
  }
}

void reserve_texture_scratch(const TexturedWorld& world, TextureScratch& scratch) {
  scratch.backend = open_search(world);
  const std::size_t of_object = world.object.texture->coarse.triangles.size();
  std::size_t of_scene = 0;
  for (const TexturedBody& body : world.scene)
    of_scene = std::max(of_scene, body.texture->coarse.triangles.size());
  scratch.object_triangles.assign(kMaxClusters, {});
  scratch.scene_triangles.assign(kMaxClusters, {});
  for (auto& list : scratch.object_triangles) list.reserve(of_object);
  for (auto& list : scratch.scene_triangles) list.reserve(of_scene);
  scratch.object_marks.assign(of_object, 0);
  scratch.scene_marks.assign(of_scene, 0);
  scratch.round = 0;
  scratch.contacts.reserve(kMaxClusters);
  scratch.cluster.reserve(kMaxClusters);
  scratch.body.reserve(kMaxClusters);
  scratch.samples.resize(kMaxClusters);
  scratch.deepest.assign(kMaxClusters, 0.0);
  scratch.gradient.object.triangles.reserve(of_object);
  scratch.gradient.object.hidden.reserve(of_object);
  scratch.gradient.scene.triangles.reserve(of_scene);
  scratch.gradient.scene.hidden.reserve(of_scene);
}

LinearContactModel linearize_textured(
    const TexturedWorld& world, const Pose& world_from_object, std::span<const SceneBody> bodies,
    std::span<const Contact> contacts, const ContactClusters& clusters,
    std::span<const std::int32_t> assignment, const PenaltyParams& penalty, const BodyState& state,
    double time, std::uint64_t sequence, TextureScratch& scratch) noexcept {
  divide(world, world_from_object, bodies, contacts, clusters, assignment, state.position, scratch);
  double amplitude = 0.0;
  for (const DepthContact& contact : scratch.contacts)
    amplitude = std::max(amplitude, amplitude_of(contact));
  const TextureParams& params = world.params;
  const std::size_t count = scratch.contacts.size();
  if (count > 0)
    scratch.backend->sample(scratch.contacts,
                            depth_request(params.gradient, amplitude, params.smoothing),
                            std::span(scratch.samples).first(count));
  StaticVector<DepthTerm, kMaxClusters> terms;
  double total = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const DepthSamples& sample = scratch.samples[i];
    const DepthGradient gradient =
        depth_gradient(scratch.contacts[i], sample, params.gradient, scratch.gradient);
    if (!gradient.is_valid) continue;
    // Sheets that only lie over each other along n, far behind the contact, are not in contact.
    const double relief = world.object.relief + world.scene[at(scratch.body[i])].relief;
    const double most = std::max(scratch.deepest[i], 0.0) + 2.0 * relief + penalty.tolerance;
    DepthTerm term;
    term.depth = std::min(sample.depth[0], most);
    term.linear = gradient.linear;
    term.angular = gradient.angular;
    term.tolerance = penalty.tolerance;
    term.id = clusters.clusters[at(scratch.cluster[i])].id;
    terms.push_back(term);
    total += std::max(term.depth + term.tolerance, 0.0);
  }
  LinearContactModel model =
      linearize_contacts(scratch.plain, penalty, state, time, sequence, total);
  total += total_reach(scratch.plain, penalty.tolerance);
  const double equal = 1.0 / static_cast<double>(std::max<std::size_t>(
                                 terms.size() + scratch.plain.clusters.size(), 1));
  for (DepthTerm& term : terms) {
    const double reach = std::max(term.depth + term.tolerance, 0.0);
    const double share = !penalty.is_shared ? 1.0 : total > 0.0 ? reach / total : equal;
    term.stiffness = share * penalty.stiffness;
    term.damping = share * penalty.damping;
    model.depths.push_back(term);
  }
  return model;
}

}  // namespace thigma
