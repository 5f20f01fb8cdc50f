#include "thigma/scene/record_session.h"

#include "thigma/clod/hierarchy.h"
#include "thigma/core/index.h"
#include "thigma/recording/config_json.h"
#include "thigma/recording/recording.h"

namespace thigma {

RecordedConfig recorded_config(const SceneSession& session, bool is_lockstep) {
  const SessionConfig& config = session.config;
  RecordedConfig recorded;
  recorded.params = config.haptic;
  recorded.world_from_body = config.world_from_body;
  recorded.rate_hz = config.rate;
  recorded.is_lockstep = is_lockstep;
  recorded.is_simulated = session.simulation != nullptr;
  recorded.resolution = config.contact.resolution;
  for (std::size_t i = 0; i < config.contact.friction.size(); ++i)
    recorded.friction.push_back(friction_on(config.contact, static_cast<std::int32_t>(i)));
  recorded.seed = session.seed;
  recorded.scene = session.scene_file;
  recorded.device = session.device_uri;
  return recorded;
}

namespace {

constexpr std::int32_t kMostTriangles = 20'000;  // of a surface in pictures: a megabyte

/// The level of detail to show, 0 the original.
std::int32_t shown_level(const ClodHierarchy& hierarchy) {
  std::int32_t level = 0;
  for (std::size_t k = 0; k < hierarchy.levels.size() && !hierarchy.levels[k].is_free; ++k) {
    level = static_cast<std::int32_t>(k);
    const std::int32_t triangles =
        k == 0 ? hierarchy.triangle_count : hierarchy.levels[k].triangle_count;
    if (triangles <= kMostTriangles) break;
  }
  return level;
}

void add_patch(const ClodHierarchy& h, const ClodPatch& patch, std::int32_t first_vertex,
               std::int32_t vertex_count, const Pose& placed, RecordedSurface& surface) {
  const auto offset = static_cast<std::int32_t>(surface.positions.size());
  for (std::int32_t v = first_vertex; v < first_vertex + vertex_count; ++v)
    surface.positions.push_back(transform_point(placed, h.vertices[idx(v)]));
  for (std::int32_t t = patch.first_triangle; t < patch.first_triangle + patch.triangle_count;
       ++t) {
    const HullTriangle& triangle = h.hull_triangles[idx(t)];
    surface.triangles.push_back(
        {offset + triangle.corner[0], offset + triangle.corner[1], offset + triangle.corner[2]});
  }
}

RecordedSurface surface_of(const ClodHierarchy& h, const Pose& placed) {
  RecordedSurface surface;
  const std::int32_t level = shown_level(h);
  if (level == 0) {
    for (const ClodPatch& patch : h.patches) {
      const ClodNode& node = h.nodes[idx(patch.node)];
      add_patch(h, patch, node.first_vertex, node.vertex_count, placed, surface);
    }
  }
  for (const LevelPatch& patch : h.level_patches)
    if (patch.level == level)
      add_patch(h, patch.patch, patch.first_vertex, patch.vertex_count, placed, surface);
  return surface;
}

}  // namespace

void record_surfaces(const ContactWorld& world, RecordingWriter& writer) {
  if (world.object != nullptr) {
    RecordedSurface object = surface_of(*world.object, world.body_from_mesh);
    object.id = "object";
    object.is_object = true;
    writer.write(object);
  }
  for (std::size_t i = 0; i < world.scene.size(); ++i) {
    RecordedSurface body = surface_of(*world.scene[i].hierarchy, world.scene[i].world_from_body);
    body.id = "static " + std::to_string(i);
    writer.write(body);
  }
}

SessionSinks recording_sinks(RecordingWriter& writer) {
  return {[&writer](const HapticSample& sample) { writer.write(sample); },
          [&writer](const ContactSample& sample) { writer.write(sample); },
          [&writer](const SessionEvent& event) { writer.write(event); }};
}

SessionSummary record_lockstep(SceneSession& session, const std::string& path,
                               const std::atomic<bool>* stop) {
  RecordingWriter writer(path, write_config(recorded_config(session, true)));
  record_surfaces(session.config.contact, writer);
  const SessionSummary summary = run_lockstep(session, recording_sinks(writer), stop);
  writer.close({summary.frames, summary.state_hash, summary.dropped_samples});
  return summary;
}

}  // namespace thigma
