#pragma once
// The binary messages of docs/protocol.md as bytes, and back.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/server/channels.h"

#include "thigma/clod/hierarchy.h"
#include "thigma/device/web_motion.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/session/live_ports.h"

namespace thigma::live {

inline constexpr int kProtocol = 1;

enum class MessageKind : std::uint8_t {
  mesh = 1,
  channels = 2,
  snapshot = 3,
  level = 4,
  relief = 5,
  bodies = 6,
  device = 32,
  upload = 33
};

/// One haptic frame as a row: its time, and every channel after the first.
struct ChannelRow {
  double time = 0.0;  // [s; session clock]
  std::array<float, kChannels - 1> values{};
};

enum StateBit : std::uint16_t {
  kGrasped = 1,
  kArmed = 2,
  kFaulty = 4,
  kPaused = 8,
  kEnded = 16,
  kFading = 32,
  kHeldBack = 64,
  kSqueezed = 128,
  kConstrained = 256  // of snapshots alone
};

/// A cluster as it is shown.
struct ViewedCluster {
  Vec3 point = Vec3::Zero();    // of the object now [m; world]
  Vec3 normal = Vec3::UnitZ();  // out of the object
  double depth = 0.0;           // now [m]
  Vec3 force = Vec3::Zero();    // on the object [N; world, virtual size]
  std::int32_t id = -1;
};

/// Most rows of a model that are shown: those that press, then the nearest.
inline constexpr std::size_t kViewedRows = 64;

/// A row of the constrained response as it is shown.
struct ViewedRow {
  Vec3 point = Vec3::Zero();    // of the object, where the two features are nearest [m; world]
  Vec3 normal = Vec3::UnitZ();  // out of the object; point + gap normal is of the scene [world]
  double gap = 0.0;             // [m]
  Vec3 force = Vec3::Zero();    // on the object, friction included [N; world, virtual size]
  double friction = 0.0;        // Coulomb's coefficient
  RowKind kind = RowKind::scene_plane;
  bool presses = false;
};

/// Everything of a `snapshot`; what each field means stands in docs/protocol.md.
struct Snapshot {
  double time = 0.0;
  std::uint64_t frame = 0;
  std::uint16_t bits = 0;  // of StateBit
  Fault fault = Fault::none;
  Pose object, ghost, handle;  // world_from_mesh, world_from_mesh, in the world
  Vec3 grasp_point = Vec3::Zero(), center = Vec3::Zero();
  Wrench on_hand;  // about the handle; world axes, device size
  Wrench contact;  // on the object about its centre of mass; world, virtual size
  double penetration = 0.0, stretch = 0.0, energy = 0.0, model_age = 0.0, model_weight = 0.0;
  double haptic_hz = 0.0, contact_hz = 0.0, query_cpu = 0.0, newton_length = 0.0;
  std::int64_t found = 0, dropped = 0, front = 0;
  std::span<const ViewedContact> contacts;
  std::span<const ViewedCluster> clusters;
  std::span<const ViewedRow> rows;
};

/// `mesh`, number `mesh_number`. The hierarchy is that of the mesh, or null: then one patch of all.
/// Thread    [offline]; throws std::bad_alloc.
std::string encode_mesh(std::uint32_t mesh_number, const TriangleMesh& mesh,
                        const ClodHierarchy* hierarchy);

/// `level`: the surface of a simplified level of the mesh with that number.
/// level     1 or more; mesh: its surface, what the triangle_ids of its contact patches index
/// Thread    any; throws std::bad_alloc.
std::string encode_level(std::uint32_t mesh_number, std::int32_t level, const TriangleMesh& mesh,
                         const ClodHierarchy& hierarchy);

/// `relief`: a surface each of whose coarse triangles is divided into divisions^2, in their order.
/// Its points are not shared between coarse triangles. Hierarchy: of the coarse mesh.
/// Thread    any; throws std::bad_alloc.
std::string encode_divided(std::uint32_t mesh_number, const TriangleMesh& fine,
                           const TriangleMesh& coarse, int divisions,
                           const ClodHierarchy& hierarchy);

/// `channels`, of at least one row.
std::string encode_channels(std::span<const ChannelRow> rows);

/// `snapshot`. What is not finite goes as NaN; contacts, clusters and rows beyond the
/// protocol's number are left out.
std::string encode_snapshot(const Snapshot& snapshot);

/// The samples of a `device` message, or why it is none: one line for the page.
struct DeviceMessage {
  double sent = 0.0;  // [s; browser's clock]
  std::vector<WebSample> samples;
  std::string problem;  // "" when it is one
};
DeviceMessage decode_device(std::string_view message);

/// The bytes of an `upload` message, within `message`; nothing when it is none.
std::optional<std::string_view> decode_upload(std::string_view message);

/// `device` as a page writes it, for tests and other clients.
std::string encode_device(double sent, std::span<const WebSample> samples);

}  // namespace thigma::live
