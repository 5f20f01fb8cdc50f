#include "thigma/constraint/relief_rows.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/infinity.h"

namespace thigma {
namespace {

constexpr double kError = 0.01;  // of the amplitude: what a row may leave out
// Peaks are looked for this many times the travel away: as much as it may close where the flatter
// of two surfaces rises by two.
constexpr double kMargin = 3.0;

bool has_relief(const HapticTexture& texture, const std::array<Vec2, 3>& corners) noexcept {
  const Vec2 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
             high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  const auto within = [](double at, int count) {
    return std::clamp(static_cast<int>(at), 0, count - 1);
  };
  for (int row = within(std::floor(low.y()), texture.height);
       row <= within(std::ceil(high.y()), texture.height); ++row) {
    for (int column = within(std::floor(low.x()), texture.width);
         column <= within(std::ceil(high.x()), texture.width); ++column) {
      const Texel& t = texel_at(texture, column, row);
      if (t.x != 0.0f || t.y != 0.0f || t.z != 0.0f) return true;
    }
  }
  return false;
}

std::vector<std::uint8_t> relief_of_patches(const TexturedBody& body) {
  const ClodHierarchy& h = *body.hierarchy;
  std::vector<std::uint8_t> marks;
  for (const ClodPatch& patch : h.patches) {
    bool any = false;
    for (std::int32_t i = patch.first_triangle;
         !any && i < patch.first_triangle + patch.triangle_count; ++i)
      any = has_relief(*body.textures[0], body.textures[0]->corners[idx(h.triangle_ids[idx(i)])]);
    marks.push_back(any ? 1 : 0);
  }
  return marks;
}

bool is_marked(const std::vector<std::uint8_t>& marks, std::int32_t patch) noexcept {
  return patch >= 0 && idx(patch) < marks.size() && marks[idx(patch)] != 0;
}

void part(const ReliefContacts& all, ReliefScratch& scratch) noexcept {
  scratch.touching.clear();
  clear(scratch.plain);
  scratch.plain.dropped = all.contacts.dropped;
  for (const Contact& contact : all.contacts.contacts) {
    const bool is_rough = is_marked(all.patches.object, contact.object_patch) ||
                          is_marked(all.patches.scene[idx(contact.body)], contact.scene_patch);
    (is_rough ? scratch.touching : scratch.plain.contacts).push_back(contact);
  }
}

/// The known row of the same place on either surface, else a new one.
std::uint64_t id_at(const ReliefScratch::Known& here, double near,
                    ReliefScratch& scratch) noexcept {
  ReliefScratch::Known* best = nullptr;
  double least = near;
  for (ReliefScratch::Known& known : scratch.known) {
    if (known.is_taken || known.body != here.body) continue;
    const double away = std::min((known.on_object - here.on_object).norm(),
                                 (known.on_scene - here.on_scene).norm());
    if (away < least) least = away, best = &known;
  }
  if (best == nullptr) return scratch.new_id++;
  best->is_taken = true;
  return best->id;
}

/// Row of a peak; points and directions as of FoundRow. Its gap is the depth of the peak's shape,
/// over the length of its gradient.
FoundRow row_of(const DepthPeak& peak, const ContactFrame& frame, const Pose& world_from_object) {
  FoundRow found;
  const Mat3& axes = frame.world_from_contact;
  const Vec3 gradient(peak.slope.x(), peak.slope.y(), 1.0);
  const double length = gradient.norm();
  found.gap = -peak.depth / length;
  found.row.kind = RowKind::relief;
  found.row.plane = axes.col(2);
  found.row.scene_direction = axes * (gradient / length);
  const Vec3 point = frame.origin + axes * peak.object_point;
  found.row.scene_point = point - peak.depth * found.row.plane;
  found.row.object_point = transform_point(inverse(world_from_object), point);
  const TangentPair tangent = relief_frame(found.row);
  Mat2 along;
  along.col(0) = (axes.transpose() * tangent.first).head<2>();
  along.col(1) = (axes.transpose() * tangent.second).head<2>();
  const Mat2 bend = along.transpose() * peak.bend * along / length;
  found.row.object_direction = {bend(0, 0), bend(0, 1), bend(1, 1)};
  return found;
}

/// A contact that was searched.
struct ReliefContact {
  ContactFrame frame;
  std::int32_t body = 0;
  const PeakRequest& request;
  const PeakStats& found;
};

/// How far the rows of a contact hold, for this frame and to begin the next with.
void bound_travel(const ReliefContact& c, ReliefScratch& scratch) noexcept {
  const double error = c.request.error, excess = c.found.excess;
  scratch.travel = std::min(scratch.travel, c.found.travel);
  scratch.stats.bent += excess > error ? 1 : 0;
  // What is left out grows with the cube of the way.
  const double growth = std::cbrt(error / std::max(excess, 0.1 * error));
  scratch.next_travel =
      std::min(scratch.next_travel, std::clamp(0.85 * growth, 0.5, 2.0) * c.found.travel);
  // What did not fit lies below the last.
  if (c.found.left_out > 0)
    scratch.travel = std::min(scratch.travel, std::max(-scratch.peaks.back().depth, 0.0) / kMargin);
  scratch.stats.left_out += c.found.left_out;
}

/// Whether a way of the travel may close a row's gap.
bool may_meet(const FoundRow& found, double travel) noexcept {
  constexpr double kMet = 1.25;  // of the travel: what its first order may leave out
  const Vec3& bend = found.row.object_direction;
  const double rises =
      std::max({bend.x() + std::fabs(bend.y()), bend.z() + std::fabs(bend.y()), 0.0});
  return found.gap <= kMet * travel + 0.5 * rises * travel * travel;
}

void add_rows(const ReliefContact& c, const Pose& world_from_object,
              ReliefScratch& scratch) noexcept {
  for (const DepthPeak& peak : scratch.peaks) {
    scratch.stats.deepest = std::max(scratch.stats.deepest, peak.depth);
    FoundRow row = row_of(peak, c.frame, world_from_object);
    if (!may_meet(row, c.found.travel)) continue;
    if (scratch.rows.size() == scratch.rows.capacity()) {
      ++scratch.stats.left_out;
      continue;
    }
    ReliefScratch::Known here{0, c.body, row.row.object_point, row.row.scene_point, false};
    row.row.body = c.body;
    here.id = row.row.id = id_at(here, 2.0 * c.request.travel, scratch);
    scratch.rows.push_back(row);
    scratch.next.push_back(here);
  }
}

/// The nearest rows, as many as there is room for beside those of features: the others end the
/// travel.
void keep_nearest(ReliefScratch& scratch) noexcept {
  constexpr std::size_t kMost = 160;
  if (scratch.rows.size() <= kMost) return;
  std::sort(scratch.rows.begin(), scratch.rows.end(), [](const FoundRow& a, const FoundRow& b) {
    return a.gap != b.gap ? a.gap < b.gap : a.row.id < b.row.id;
  });
  scratch.stats.left_out += static_cast<std::int64_t>(scratch.rows.size() - kMost);
  scratch.travel = std::min(scratch.travel, std::max(scratch.rows[kMost].gap, 0.0) / kMargin);
  scratch.rows.resize(kMost);
}

}  // namespace

ReliefPatches find_relief_patches(const TexturedWorld& world) {
  ReliefPatches patches;
  if (world.is_empty()) return patches;
  patches.object = relief_of_patches(world.object);
  for (const TexturedBody& body : world.scene) patches.scene.push_back(relief_of_patches(body));
  return patches;
}

void reserve_relief(const TexturedWorld& world, std::size_t capacity, ReliefScratch& scratch) {
  reserve_peaks(scratch.search);
  reserve_depth_contacts(world, scratch.textures);
  scratch.plain.contacts.reserve(capacity);
  scratch.touching.reserve(capacity);
  reserve_clusters(scratch.clustering, capacity);
  const std::size_t most = idx(kMaxContactClusters) * kMaxPeaks;
  scratch.rows.reserve(most);
  scratch.known.reserve(most);
  scratch.next.reserve(most);
}

void find_relief_rows(const ReliefContacts& touching, const Pose& world_from_object,
                      const Vec3& centre, const ReliefReach& reach,
                      ReliefScratch& scratch) noexcept {
  part(touching, scratch);
  scratch.rows.clear();
  scratch.stats = {};
  const double wanted =
      scratch.known.empty() ? reach.travel : std::min(reach.travel, scratch.next_travel);
  scratch.travel = wanted;
  scratch.next_travel = kInfinity;
  ClusterParams params;
  params.max_clusters = touching.max_clusters;
  params.tolerance = touching.tolerance + relief_of(touching.world);
  cluster_contacts(scratch.touching, scratch.clusters, params, scratch.clustering,
                   scratch.clusters);
  find_depth_contacts({touching.world, world_from_object, touching.bodies, scratch.touching,
                       scratch.clusters, scratch.clustering.assignment},
                      centre, scratch.textures);
  scratch.stats.left_out += scratch.textures.left_out;
  if (scratch.textures.left_out > 0) scratch.travel = 0.0;  // nobody knows how near those are
  scratch.next.clear();
  for (ReliefScratch::Known& known : scratch.known) known.is_taken = false;
  for (std::size_t i = 0; i < scratch.textures.contacts.size(); ++i) {
    const std::int32_t body = scratch.textures.body[i];
    const TexturedBody &object = touching.world.object, &scene = touching.world.scene[idx(body)];
    // Displacements may all be along the surface.
    const double amplitude =
        std::max(object.amplitude + scene.amplitude, 0.1 * (object.relief + scene.relief));
    PeakRequest request;
    request.travel = wanted;
    request.turn = reach.turn * wanted / reach.travel;
    request.least = -kMargin * wanted;
    request.near = -2.0 * wanted;
    request.error = kError * amplitude;
    request.least_travel = std::min(reach.least_travel, wanted);
    const DepthContact& contact = scratch.textures.contacts[i];
    const PeakStats found = find_peaks(contact, request, scratch.search, scratch.peaks);
    scratch.stats.depths += found.is_found ? 1 : 0;
    scratch.stats.folds += found.is_found && !found.is_height_field ? 1 : 0;
    scratch.stats.coarse += found.is_coarse ? 1 : 0;
    if (scratch.peaks.empty()) continue;
    const ReliefContact searched{contact_frame(contact.point, contact.normal), body, request,
                                 found};
    bound_travel(searched, scratch);
    add_rows(searched, world_from_object, scratch);
  }
  keep_nearest(scratch);
  std::swap(scratch.known, scratch.next);
}

}  // namespace thigma
