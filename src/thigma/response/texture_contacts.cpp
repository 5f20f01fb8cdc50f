// A cluster is one contact of Sec. 4.2.2: the triangles of its members' patches on either side, at
// one level of detail each, its mean normal, its centre. Members of one cluster may belong to
// several bodies; each body has a texture of its own and so a term.
#include "thigma/response/texture_contacts.h"

#include <algorithm>
#include <cmath>

#include "thigma/contact/contact_node.h"
#include "thigma/core/index.h"
#include "thigma/depth/gpu_depth.h"
#include "thigma/response/linearize_contacts.h"

namespace thigma {
namespace {

/// A patch as contacts name it, or the one of a coarser level that it lies below; null without one.
const ClodPatch* patch_at_level(const TexturedBody& body, std::int32_t patch,
                                std::int32_t level) noexcept {
  const ClodHierarchy& h = *body.hierarchy;
  std::int32_t node = contact_node(h, patch);
  while (node >= 0 && h.nodes[idx(node)].level < level) node = body.parent[idx(node)];
  if (node < 0) return nullptr;
  const ClodNode& n = h.nodes[idx(node)];
  if (n.patch >= 0) return &h.patches[idx(n.patch)];
  return n.contact >= 0 ? &h.level_patches[idx(n.contact)].patch : nullptr;
}

/// Adds the triangles of a patch, at a level, that are not there yet.
void add_triangles(const TexturedBody& body, std::int32_t patch, std::int32_t level,
                   TriangleMarks& marks, std::vector<std::int32_t>& triangles) noexcept {
  const ClodPatch* const p = patch_at_level(body, patch, level);
  if (p == nullptr) return;
  for (std::int32_t i = p->first_triangle; i < p->first_triangle + p->triangle_count; ++i) {
    const std::int32_t t = body.hierarchy->triangle_ids[idx(i)];
    if (marks.add(t)) triangles.push_back(t);
  }
}

/// Levels of detail at which a cluster looks at the object and at a body.
struct Levels {
  std::int32_t object = 0, scene = 0;
};

/// A cluster as it touches one body of the scene, by their numbers.
struct ClusterOnBody {
  std::int32_t cluster = 0, body = 0;
};

bool is_member(const TexturedContacts& touching, std::size_t contact,
               const ClusterOnBody& pair) noexcept {
  return touching.assignment[contact] == pair.cluster &&
         touching.contacts[contact].body == pair.body;
}

/// The coarsest levels among the members of a cluster.
Levels coarsest_levels(const TexturedContacts& touching, const ClusterOnBody& pair) noexcept {
  Levels levels;
  for (std::size_t i = 0; i < touching.contacts.size(); ++i) {
    if (!is_member(touching, i, pair)) continue;
    const Contact& contact = touching.contacts[i];
    levels.object = std::max(levels.object, contact.object_level);
    levels.scene = std::max(levels.scene, contact.scene_level);
  }
  return levels;
}

/// The object, and a body of the scene, as one cluster touches them. False without such members.
bool gather(const TexturedContacts& touching, const ClusterOnBody& pair, const Levels& levels,
            std::size_t slot, TextureScratch& scratch) noexcept {
  const TexturedBody& object = touching.world.object;
  const TexturedBody& scene = touching.world.scene[idx(pair.body)];
  scratch.object_marks.begin();
  scratch.scene_marks.begin();
  std::vector<std::int32_t>&of_object = scratch.object_triangles[slot],
  &of_scene = scratch.scene_triangles[slot];
  of_object.clear();
  of_scene.clear();
  double deepest = kNoDepth;
  for (std::size_t i = 0; i < touching.contacts.size(); ++i) {
    if (!is_member(touching, i, pair)) continue;
    const Contact& contact = touching.contacts[i];
    add_triangles(object, contact.object_patch, levels.object, scratch.object_marks, of_object);
    add_triangles(scene, contact.scene_patch, levels.scene, scratch.scene_marks, of_scene);
    deepest = std::max(deepest, contact.depth + contact.bound);
  }
  // Clusters name their members in the order of contacts, which may change while the triangles do
  // not.
  std::sort(of_object.begin(), of_object.end());
  std::sort(of_scene.begin(), of_scene.end());
  const auto look_beside = [](const TexturedBody& of, std::int32_t level, const auto& own,
                              TriangleMarks& marks, std::vector<std::int32_t>& around) {
    around.clear();
    add_ring(of.textures[idx(level)]->coarse, of.at_vertex[idx(level)], own, marks, around);
  };
  look_beside(object, levels.object, of_object, scratch.object_marks, scratch.object_around[slot]);
  look_beside(scene, levels.scene, of_scene, scratch.scene_marks, scratch.scene_around[slot]);
  scratch.deepest[slot] = deepest;
  return !of_object.empty() && !of_scene.empty();
}

bool touches(const TexturedContacts& touching, const ClusterOnBody& pair) noexcept {
  for (std::size_t i = 0; i < touching.contacts.size(); ++i)
    if (is_member(touching, i, pair)) return true;
  return false;
}

bool touches_relief(const TexturedContacts& touching, std::int32_t cluster) noexcept {
  for (std::size_t i = 0; i < touching.contacts.size(); ++i) {
    if (touching.assignment[i] == cluster && is_textured(touching.world, touching.contacts[i].body))
      return true;
  }
  return false;
}

}  // namespace

void find_depth_contacts(const TexturedContacts& touching, const Vec3& centre,
                         TextureScratch& scratch) noexcept {
  const TexturedWorld& world = touching.world;
  const ContactClusters& clusters = touching.clusters;
  scratch.contacts.clear();
  scratch.cluster.clear();
  scratch.body.clear();
  scratch.left_out = 0;
  scratch.plain = clusters;
  scratch.plain.clusters.clear();
  for (std::size_t c = 0; c < clusters.clusters.size(); ++c) {
    const ContactCluster& cluster = clusters.clusters[c];
    const std::int32_t index = static_cast<std::int32_t>(c);
    if (!touches_relief(touching, index)) {
      scratch.plain.clusters.push_back(cluster);
      continue;
    }
    for (std::size_t b = 0; b < world.scene.size(); ++b) {
      const std::size_t slot = scratch.contacts.size();
      const ClusterOnBody pair{index, static_cast<std::int32_t>(b)};
      if (slot == scratch.object_triangles.size()) {  // as many as the model has room for
        scratch.left_out += touches(touching, pair) ? 1 : 0;
        continue;
      }
      const Levels levels = coarsest_levels(touching, pair);
      if (!gather(touching, pair, levels, slot, scratch)) continue;
      DepthContact contact;
      contact.object = {world.object.textures[idx(levels.object)], scratch.object_triangles[slot],
                        touching.world_from_object, scratch.object_around[slot]};
      contact.scene = {world.scene[b].textures[idx(levels.scene)], scratch.scene_triangles[slot],
                       touching.bodies[b].world_from_body, scratch.scene_around[slot]};
      contact.point = cluster.point;
      contact.normal = cluster.normal;
      contact.centre = centre;
      scratch.contacts.push_back(contact);
      scratch.cluster.push_back(index);
      scratch.body.push_back(pair.body);
    }
  }
}

namespace {

std::unique_ptr<DepthBackend> open_gpu_search(const TexturedWorld& world) {
  GpuDepthParams params;
  params.grid.resolution = world.params.resolution;
  params.warn = world.warn;
  params.textures = world.object.textures;
  for (const TexturedBody& body : world.scene)
    params.textures.insert(params.textures.end(), body.textures.begin(), body.textures.end());
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

double longest_texel(const HapticTexture& texture) noexcept {
  double longest = 0.0;
  for (const Texel& t : texture.texels)
    longest = std::max(
        longest,
        Vec3(static_cast<double>(t.x), static_cast<double>(t.y), static_cast<double>(t.z)).norm());
  return longest;
}

std::size_t most_triangles(const TexturedBody& body) noexcept {
  std::size_t most = 0;
  for (const HapticTexture* texture : body.textures)
    most = std::max(most, texture->coarse.triangles.size());
  return most;
}

}  // namespace

TexturedBody make_textured_body(const HapticTexture& texture, const ClodHierarchy& hierarchy) {
  return make_textured_levels({&texture}, hierarchy);
}

TexturedBody make_textured_levels(std::vector<const HapticTexture*> textures,
                                  const ClodHierarchy& hierarchy) {
  TexturedBody body;
  body.textures = std::move(textures);
  body.hierarchy = &hierarchy;
  body.relief = longest_texel(*body.textures.front());
  for (const HapticTexture* texture : body.textures) {
    body.at_vertex.emplace_back();
    if (!(longest_texel(*texture) > 0.0)) continue;
    body.at_vertex.back() = vertex_triangles(texture->coarse);
    body.amplitude =
        body.has_relief ? std::min(body.amplitude, texture->amplitude) : texture->amplitude;
    body.has_relief = true;
  }
  if (body.textures.size() == 1) return body;
  body.parent.assign(hierarchy.nodes.size(), -1);
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i) {
    const ClodNode& node = hierarchy.nodes[i];
    for (std::int32_t c = node.first_child; c < node.first_child + node.child_count; ++c)
      body.parent[idx(c)] = static_cast<std::int32_t>(i);
  }
  return body;
}

bool has_levels(const TexturedWorld& world) noexcept {
  const auto of_body = [](const TexturedBody& body) { return body.textures.size() > 1; };
  return of_body(world.object) || std::any_of(world.scene.begin(), world.scene.end(), of_body);
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
    const double relief = contact.body >= 0 ? world.scene[idx(contact.body)].relief : 0.0;
    const double open = is_textured(world, contact.body) ? contact.bound : 0.0;
    return contact.depth + tolerance + world.object.relief + relief + open;
  };
  contacts.contacts.erase(
      std::remove_if(contacts.contacts.begin(), contacts.contacts.end(),
                     [&](const Contact& contact) { return own_reach(contact) < 0.0; }),
      contacts.contacts.end());
  // Clusters weigh by depth + most: what a coarse level leaves open may be beyond that.
  const double least = 1e-3 * tolerance - most;
  for (Contact& contact : contacts.contacts) {
    const double own = own_reach(contact);
    if (contact.bound > 0.0 && is_textured(world, contact.body))
      contact.depth = std::max(contact.depth, least);
    const double reach = contact.depth + most;
    if (reach > 0.0) contact.weight *= own / reach;
  }
}

void reserve_texture_scratch(const TexturedWorld& world, TextureScratch& scratch) {
  scratch.backend = open_search(world);
  reserve_depth_contacts(world, scratch);
}

void reserve_depth_contacts(const TexturedWorld& world, TextureScratch& scratch) {
  const std::size_t of_object = most_triangles(world.object);
  std::size_t of_scene = 0;
  for (const TexturedBody& body : world.scene) of_scene = std::max(of_scene, most_triangles(body));
  scratch.object_triangles.assign(kMaxClusters, {});
  scratch.scene_triangles.assign(kMaxClusters, {});
  for (auto& list : scratch.object_triangles) list.reserve(of_object);
  for (auto& list : scratch.scene_triangles) list.reserve(of_scene);
  scratch.object_around = scratch.object_triangles;
  scratch.scene_around = scratch.scene_triangles;
  for (auto& list : scratch.object_around) list.reserve(of_object);
  for (auto& list : scratch.scene_around) list.reserve(of_scene);
  scratch.object_marks = {std::vector<std::uint32_t>(of_object, 0u)};
  scratch.scene_marks = {std::vector<std::uint32_t>(of_scene, 0u)};
  scratch.contacts.reserve(kMaxClusters);
  scratch.cluster.reserve(kMaxClusters);
  scratch.body.reserve(kMaxClusters);
  scratch.samples.resize(kMaxClusters);
  scratch.deepest.assign(kMaxClusters, 0.0);
  scratch.gradient.object.triangles.reserve(of_object);
  scratch.gradient.object.around.reserve(of_object);
  scratch.gradient.object.hidden.reserve(of_object);
  scratch.gradient.scene.triangles.reserve(of_scene);
  scratch.gradient.scene.around.reserve(of_scene);
  scratch.gradient.scene.hidden.reserve(of_scene);
}

LinearContactModel linearize_textured(const TexturedContacts& touching,
                                      const PenaltyParams& penalty, const ModelStamp& stamp,
                                      TextureScratch& scratch) noexcept {
  const TexturedWorld& world = touching.world;
  find_depth_contacts(touching, stamp.state.position, scratch);
  double amplitude = 0.0;
  for (const std::int32_t body : scratch.body)
    amplitude = std::max(amplitude, world.object.amplitude + world.scene[idx(body)].amplitude);
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
    const double relief = world.object.relief + world.scene[idx(scratch.body[i])].relief;
    const double most = std::max(scratch.deepest[i], 0.0) + 2.0 * relief + penalty.tolerance;
    DepthTerm term;
    term.depth = std::min(sample.depth[0], most);
    term.linear = gradient.linear;
    term.angular = gradient.angular;
    term.tolerance = penalty.tolerance;
    const ContactCluster& cluster = touching.clusters.clusters[idx(scratch.cluster[i])];
    term.id = cluster.id;
    term.body = scratch.body[i];
    term.arm_body = stamp.state.orientation.conjugate() * (cluster.point - stamp.state.position);
    terms.push_back(term);
    total += std::max(term.depth + term.tolerance, 0.0);
  }
  LinearContactModel model = linearize_contacts(scratch.plain, penalty, stamp, total);
  total += total_indentation(scratch.plain, penalty.tolerance);
  const double equal = 1.0 / static_cast<double>(std::max<std::size_t>(
                                 terms.size() + scratch.plain.clusters.size(), 1));
  for (DepthTerm& term : terms) {
    const double reach = std::max(term.depth + term.tolerance, 0.0);
    const double share = !penalty.is_divided_among_clusters ? 1.0
                         : total > 0.0                      ? reach / total
                                                            : equal;
    term.stiffness = share * penalty.stiffness;
    term.damping = share * penalty.damping;
    model.depths.push_back(term);
  }
  return model;
}

}  // namespace thigma
