// A frame: every contact is projected on the processor, all maps and sums go to the graphics
// processor together, and from its largest sums on everything is as on the processor.
#include "thigma/depth/detail/gpu_backend.h"

#include <algorithm>
#include <cmath>

#include "thigma/depth/detail/grid_refinement.h"
#include "thigma/depth/detail/map_motion.h"
#include "thigma/depth/detail/near_maxima.h"
#include "thigma/depth/detail/triangle_span.h"

namespace thigma::detail {
namespace {

constexpr int kTilted = 4;  // configurations whose object map is rendered anew

// A contact of the frame.
struct GpuContact {
  std::size_t index = 0;  // among those given
  MapGrid grid;
  std::size_t first_sum = 0;
};

class GpuBackend final : public DepthBackend {
 public:
  GpuBackend(std::unique_ptr<GpuMaps> maps, const GpuDepthParams& params)
      : maps_(std::move(maps)), params_(params), processor_(make_grid_depth(params.grid)) {
    params_.grid.resolution = std::clamp(params.grid.resolution, 2, 4096);
  }

  void sample(std::span<const DepthContact> contacts, const DepthRequest& request,
              std::span<DepthSamples> results) noexcept override {
    if (maps_ && sample_there(contacts, request, results)) return;
    if (maps_) give_up();
    processor_->sample(contacts, request, results);
  }

 private:
  bool sample_there(std::span<const DepthContact> contacts, const DepthRequest& request,
                    std::span<DepthSamples> results) noexcept {
    if (!maps_->context().enter()) {
      why_ = maps_->context().renderer + ": its context cannot be made current";
      return false;
    }
    const std::int64_t each = map_samples() * (request.has_differences ? 2 + kTilted : 2);
    const std::size_t most = static_cast<std::size_t>(
        std::clamp<std::int64_t>(maps_->most_samples() / each, 1, kMostContacts));
    bool is_done = true;
    for (std::size_t first = 0; is_done && first < contacts.size(); first += most) {
      const std::size_t count = std::min(most, contacts.size() - first);
      is_done = sample_part(contacts.subspan(first, count), request, results.subspan(first, count));
    }
    maps_->context().leave();
    return is_done;
  }

  bool sample_part(std::span<const DepthContact> contacts, const DepthRequest& request,
                   std::span<DepthSamples> results) noexcept {
    prepare(contacts, request, results);
    if (used_.empty()) return true;
    if (!maps_->place(textures_, first_texels_)) return fail(maps_->why());
    build_frame(contacts, request, results);
    if (!maps_->render(frame_, peaks_)) return fail(maps_->why());
    for (std::size_t i = 0; i < used_.size(); ++i)
      if (!finish(contacts[used_[i].index], i, request, results[used_[i].index])) return false;
    return true;
  }

  // Projects all contacts and lists the textures they need.
  void prepare(std::span<const DepthContact> contacts, const DepthRequest& request,
               std::span<DepthSamples> results) noexcept {
    used_.clear();
    textures_ = params_.textures;
    if (prepared_.size() < contacts.size()) prepared_.resize(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      results[i] = DepthSamples{};
      PreparedContact& prepared = prepared_[used_.size()];
      if (!prepare_contact(contacts[i], prepared)) continue;
      results[i].frame = prepared.frame;
      const int resolution = params_.grid.resolution;
      used_.push_back({i, {prepared.box, resolution, resolution}, 0});
      if (request.has_differences)
        choose_difference_steps(contacts[i], used_.back().grid, request, results[i]);
      for (const HapticTexture* texture : {contacts[i].object.texture, contacts[i].scene.texture})
        if (std::find(textures_.begin(), textures_.end(), texture) == textures_.end())
          textures_.push_back(texture);
    }
  }

  std::int64_t map_samples() const noexcept {
    return std::int64_t{params_.grid.resolution} * params_.grid.resolution;
  }

  // Maps as they are come first, two a contact, so that they can be read back together.
  std::int64_t plain_map(std::size_t contact, bool is_scene) const noexcept {
    return (2 * static_cast<std::int64_t>(contact) + is_scene) * map_samples();
  }

  void build_frame(std::span<const DepthContact> contacts, const DepthRequest& request,
                   std::span<const DepthSamples> results) noexcept {
    frame_.resolution = params_.grid.resolution;
    frame_.triangles.clear();
    frame_.maps.clear();
    frame_.sums.clear();
    std::int64_t next = plain_map(used_.size(), false);
    for (std::size_t i = 0; i < used_.size(); ++i) {
      GpuContact& used = used_[i];
      const DepthContact& contact = contacts[used.index];
      const DepthSamples& result = results[used.index];
      used.first_sum = frame_.sums.size();
      add_map(prepared_[i].object, used.grid, plain_map(i, false));
      add_map(prepared_[i].scene, used.grid, plain_map(i, true));
      add_sum(contact, i, 0, plain_map(i, false), result);
      for (int k = 1; request.has_differences && k < kConfigurations; ++k) {
        std::int64_t map = plain_map(i, false);
        if (is_tilted(k)) {
          project_patch(
              {contact.object.texture, contact.object.triangles,
               configuration_motion(result, contact.centre, k) * contact.object.world_from_body},
              result.frame, Facing::along, moved_);
          map = next;
          next += map_samples();
          add_map(moved_, used.grid, map);
        }
        add_sum(contact, i, k, map, result);
      }
    }
    frame_.samples = next;
  }

  void add_map(const ProjectedPatch& patch, const MapGrid& grid, std::int64_t heights) noexcept {
    const Vec2 spacing = grid.spacing();
    GpuMap map;
    map.first_u = grid.at(0, 0).x();
    map.low_v = grid.box.low.y();
    map.spacing_u = spacing.x();
    map.spacing_v = spacing.y();
    map.first_triangle = static_cast<std::int32_t>(frame_.triangles.size());
    map.triangle_count = static_cast<std::int32_t>(patch.triangles.size());
    map.heights = static_cast<std::int32_t>(heights);
    frame_.maps.push_back(map);
    const auto texture = std::find(textures_.begin(), textures_.end(), patch.texture);
    const std::int32_t first = first_texels_[static_cast<std::size_t>(texture - textures_.begin())];
    for (const ProjectedTriangle& t : patch.triangles)
      frame_.triangles.push_back(gpu_triangle(patch, t, spacing.x(), first));
  }

  static GpuTriangle gpu_triangle(const ProjectedPatch& patch, const ProjectedTriangle& t,
                                  double spacing, std::int32_t first_texel) noexcept {
    GpuTriangle g;
    for (int k = 0; k < 6; ++k) g.at[k] = t.at[static_cast<std::size_t>(k / 2)][k % 2];
    for (int k = 0; k < 3; ++k) {
      g.texel_x[k] = k == 0 ? t.texel_origin.x() : t.texel_by_at(0, k - 1);
      g.texel_y[k] = k == 0 ? t.texel_origin.y() : t.texel_by_at(1, k - 1);
      g.height[k] = k == 0 ? t.height_origin : t.height_by_at[k - 1];
    }
    Vec2 origin;
    const HeightSpan span = start_span(patch, t, {spacing, 0.0}, origin);
    g.origin_x = origin.x();
    g.origin_y = origin.y();
    g.by_x = span.by_x;
    g.by_y = span.by_y;
    g.by_h = span.by_h;
    g.high_x = span.high_x;
    g.high_y = span.high_y;
    for (int k = 0; k < 3; ++k) g.m[k] = span.m[k];
    g.texel_row = static_cast<std::int32_t>(span.texel_row);
    g.first_texel = first_texel + static_cast<std::int32_t>(origin.y()) * g.texel_row +
                    static_cast<std::int32_t>(origin.x());
    return g;
  }

  void add_sum(const DepthContact& contact, std::size_t i, int configuration, std::int64_t object,
               const DepthSamples& result) noexcept {
    GpuSum sum;
    sum.object = static_cast<std::int32_t>(object);
    sum.scene = static_cast<std::int32_t>(plain_map(i, true));
    if (configuration > 0 && !is_tilted(configuration)) {
      const PlaneMotion motion = plane_motion(contact, result, configuration);
      const MapGrid& grid = used_[i].grid;
      sum.kind = motion.turn == 0.0 ? 1 : 2;
      const MapShift shift = map_shift(grid, motion.shift);
      const MapTurn turn = map_turn(grid, motion);
      for (int k = 0; k < 4; ++k) sum.back[k] = turn.back(k / 2, k % 2);
      for (int k = 0; k < 2; ++k) {
        sum.centre[k] = turn.centre[k];
        sum.shift[k] = turn.shift[k];
        sum.first[k] = turn.first[k];
        sum.spacing[k] = turn.spacing[k];
        sum.low[k] = grid.box.low[k];
        sum.by_column[k] = turn.by_column[k];
        sum.whole[k] = shift.whole[k];
        sum.begin[k] = shift.first[k];
        sum.end[k] = shift.last[k];
        sum.way[k] = shift.way[k];
      }
    }
    frame_.sums.push_back(sum);
  }

  // From the largest sums to the result; false: they are no depths of this contact.
  bool finish(const DepthContact& contact, std::size_t i, const DepthRequest& request,
              DepthSamples& result) noexcept {
    const GpuContact& used = used_[i];
    PreparedContact& prepared = prepared_[i];
    const MapGrid& grid = used.grid;
    const GpuPeak& peak = peaks_[used.first_sum];
    if (peak.index < 0) return true;
    const MapMaximum best{peak.sum, peak.index % grid.columns, peak.index / grid.columns};
    if (!is_credible(contact, prepared, grid, best)) return fail("gave a depth that is none there");
    result.is_found = true;
    if ((params_.grid.is_polished || request.near > 0.0) &&
        (!read_map(plain_map(i, false), grid, object_) ||
         !read_map(plain_map(i, true), grid, scene_)))
      return fail(maps_->why());
    climb_to_maximum(params_.grid, prepared, {object_, scene_, grid}, best, result);
    if (request.near > 0.0) {
      collect_near(object_, scene_, grid, request.near, result);
    } else {
      result.near.push_back({result.at, 1.0});
    }
    for (int k = 1; request.has_differences && k < kConfigurations; ++k) {
      const GpuPeak& moved = peaks_[used.first_sum + static_cast<std::size_t>(k)];
      if (moved.index >= 0)
        result.depth[static_cast<std::size_t>(k)] = static_cast<double>(moved.sum);
    }
    return true;
  }

  // Whether a sum is the depth at its sample, as far as a broken processor could have it.
  static bool is_credible(const DepthContact& contact, const PreparedContact& prepared,
                          const MapGrid& grid, const MapMaximum& best) noexcept {
    if (best.row >= grid.rows || !std::isfinite(best.sum)) return false;
    NearTriangles near;
    const double depth = depth_at(prepared, grid.at(best.column, best.row), near);
    if (depth == kNoDepth) return true;  // on an edge, which the two may see differently
    const double relief = contact.object.texture->amplitude + contact.scene.texture->amplitude;
    const double size = (grid.box.high - grid.box.low).norm();
    constexpr double kBeyondRounding = 100.0;
    return std::fabs(depth - static_cast<double>(best.sum)) <=
           kBeyondRounding * kGpuPrecision * (relief + size);
  }

  bool read_map(std::int64_t first, const MapGrid& grid, HeightMap& map) noexcept {
    map.columns = grid.columns;
    map.rows = grid.rows;
    map.heights.resize(static_cast<std::size_t>(map_samples()));
    return maps_->read_heights(first, map.heights);
  }

  bool fail(const std::string& why) noexcept {
    why_ = why;
    return false;
  }

  void give_up() noexcept {
    maps_.reset();
    if (params_.warn) params_.warn("textures are computed on the processor from now on: " + why_);
  }

  // Indices of samples and triangles stay within 32 bits.
  static constexpr std::int64_t kMostContacts = 4096;

  std::unique_ptr<GpuMaps> maps_;  // null once it was lost
  GpuDepthParams params_;
  std::unique_ptr<DepthBackend> processor_;
  std::vector<PreparedContact> prepared_;  // one a used contact
  std::vector<GpuContact> used_;
  std::vector<const HapticTexture*> textures_;
  std::vector<std::int32_t> first_texels_;
  ProjectedPatch moved_;
  GpuFrame frame_;
  std::vector<GpuPeak> peaks_;
  HeightMap object_, scene_;
  std::string why_;
};

// A plate of two triangles with a wave, looking up or down.
TextureSource small_plate(bool looks_up) {
  constexpr int kSide = 17;
  TextureSource source;
  source.coarse.positions = {
      {0.0, 0.0, 0.0}, {0.016, 0.0, 0.0}, {0.016, 0.016, 0.0}, {0.0, 0.016, 0.0}};
  source.coarse.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Vec2 at[] = {{0.0, 0.0}, {16.0, 0.0}, {16.0, 16.0}, {0.0, 16.0}};
  for (std::array<std::int32_t, 3>& t : source.coarse.triangles) {
    if (!looks_up) std::swap(t[1], t[2]);
    source.corners.push_back({at[t[0]], at[t[1]], at[t[2]]});
  }
  source.width = source.height = kSide;
  for (int k = 0; k < kSide * kSide; ++k)
    source.texels.push_back({0.0f, 0.0f, 1e-4f * static_cast<float>(k * k % 23)});
  return source;
}

}  // namespace

std::unique_ptr<DepthBackend> make_gpu_backend(std::unique_ptr<GpuMaps> maps,
                                               const GpuDepthParams& params) {
  return std::make_unique<GpuBackend>(std::move(maps), params);
}

std::string differs_from_scalar(DepthBackend& backend, const GridDepthParams& grid) {
  // Kept: textures stay in place as long as a backend is used.
  static const HapticTexture object = make_texture(small_plate(true), "object"),
                             scene = make_texture(small_plate(false), "scene");
  const std::int32_t triangles[] = {0, 1};
  DepthContact contact;
  contact.object = {&object, triangles,
                    Pose{Vec3(0.002, 0.001, 0.0), Quat(0.9999, 0.0, 0.0, 0.01).normalized()}};
  contact.scene = {&scene, triangles, Pose{}};
  contact.point = Vec3(0.008, 0.008, 0.0);
  contact.centre = Vec3(0.0, 0.0, -0.02);
  GridDepthParams scalar = grid;
  scalar.width = SpanWidth::scalar;
  scalar.has_quads = false;  // shaders read displacements
  const DepthRequest request{.has_differences = true};
  DepthSamples got, want;
  backend.sample({&contact, 1}, request, {&got, 1});
  make_grid_depth(scalar)->sample({&contact, 1}, request, {&want, 1});
  if (got.is_found != want.is_found) return "finds no depth where there is one";
  const double most = kGpuPrecision * (object.amplitude + scene.amplitude);
  for (std::size_t k = 0; k < want.depth.size(); ++k)
    if (!(std::fabs(got.depth[k] - want.depth[k]) <= most))
      return "depth " + std::to_string(k) + " is off by " +
             std::to_string(1e6 * (got.depth[k] - want.depth[k])) + " um";
  return "";
}

}  // namespace thigma::detail
