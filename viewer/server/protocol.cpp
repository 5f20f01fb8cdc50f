#include "viewer/server/protocol.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "viewer/server/detail/wire.h"

namespace thigma::live {

using namespace detail;

namespace {

constexpr std::size_t kSampleBytes = 40;
constexpr std::size_t kMostSamples = 64;
constexpr std::size_t kMostClusters = 16;

template <class T>
T get(std::string_view in, std::size_t at) {
  T value;
  std::memcpy(&value, in.data() + at, sizeof(T));
  return value;
}

std::uint32_t counted(std::int64_t n) {
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(n, 0, 0xffffffff));
}

/// Gives the triangles of a patch its number.
void mark_patch(const ClodHierarchy& h, const ClodPatch& patch, std::uint32_t number,
                std::vector<std::uint32_t>& patch_of) {
  for (std::int32_t i = patch.first_triangle; i < patch.first_triangle + patch.triangle_count;
       ++i) {
    const auto triangle = static_cast<std::size_t>(h.triangle_ids[static_cast<std::size_t>(i)]);
    if (triangle < patch_of.size()) patch_of[triangle] = number;
  }
}

/// Finest patch of every triangle of the mesh the hierarchy was built of.
std::vector<std::uint32_t> patch_of_triangles(const TriangleMesh& mesh, const ClodHierarchy* h) {
  std::vector<std::uint32_t> patch(mesh.triangles.size(), h == nullptr ? 0u : 0xffffffffu);
  if (h == nullptr) return patch;
  for (std::size_t p = 0; p < h->patches.size(); ++p)
    mark_patch(*h, h->patches[p], static_cast<std::uint32_t>(p), patch);
  return patch;
}

void put_surface(std::string& out, const TriangleMesh& mesh) {
  for (const Vec3& p : mesh.positions) put_vector(out, p);
  for (const auto& triangle : mesh.triangles) {
    for (const std::int32_t corner : triangle) put(out, static_cast<std::uint32_t>(corner));
  }
}

void put_tree(std::string& out, const ClodHierarchy& h) {
  for (const ClodPatch& patch : h.patches) put(out, patch.node);
  std::vector<std::int32_t> parent(h.nodes.size(), -1);
  for (std::size_t n = 0; n < h.nodes.size(); ++n) {
    const ClodNode& node = h.nodes[n];
    for (std::int32_t c = 0; c < node.child_count; ++c)
      parent[static_cast<std::size_t>(node.first_child + c)] = static_cast<std::int32_t>(n);
  }
  for (const std::int32_t p : parent) put(out, p);
  for (const ClodNode& node : h.nodes) put(out, node.level);
}

void put_fields(std::string& out, const Snapshot& s) {
  put_pose(out, s.object);
  put_pose(out, s.ghost);
  put_pose(out, s.handle);
  put_vector(out, s.grasp_point);
  put_vector(out, s.on_hand.force);
  put_vector(out, s.on_hand.torque);
  put_vector(out, s.contact.force);
  put_vector(out, s.contact.torque);
  put_vector(out, s.center);
  for (const double value : {s.penetration, s.stretch, s.energy, s.model_age, s.model_weight,
                             s.haptic_hz, s.contact_hz, s.query_cpu, s.newton_length}) {
    put_float(out, value);
  }
}

void put_contact(std::string& out, const ViewedContact& c) {
  put_vector(out, c.point);
  put_vector(out, c.normal);
  put_float(out, c.depth);
  put_float(out, c.bound);
  put(out, c.body);
  put(out, c.object_node);
  put(out, c.scene_node);
  put(out, c.object_level | static_cast<std::uint32_t>(c.scene_level) << 8 |
               static_cast<std::uint32_t>(c.status) << 16 |
               static_cast<std::uint32_t>(c.decided_by) << 24);
}

void put_cluster(std::string& out, const ViewedCluster& c) {
  put_vector(out, c.point);
  put_vector(out, c.normal);
  put_float(out, c.depth);
  put_vector(out, c.force);
  put(out, c.id);
  put(out, std::uint32_t{0});
}

void put_row(std::string& out, const ViewedRow& r) {
  put_vector(out, r.point);
  put_vector(out, r.normal);
  put_float(out, r.gap);
  put_vector(out, r.force);
  put_float(out, r.friction);
  put(out, static_cast<std::uint32_t>(r.kind) | (r.presses ? 4u : 0u));
}

/// "" or what is wrong with a sample.
std::string wrong_with(const WebSample& sample) {
  constexpr double kFarthest = 10.0;  // [m]
  const Vec3& p = sample.pose.position;
  if (!std::isfinite(sample.time) || !p.allFinite() ||
      !sample.pose.orientation.coeffs().allFinite())
    return "a number is not finite";
  if (p.cwiseAbs().maxCoeff() > kFarthest) return "the handle is more than 10 m away";
  if (std::abs(sample.pose.orientation.norm() - 1.0) > 1e-3) return "a quaternion is not unit";
  return {};
}

}  // namespace

std::string encode_mesh(std::uint32_t mesh_number, const TriangleMesh& mesh,
                        const ClodHierarchy* hierarchy) {
  std::string out;
  put_header(out, MessageKind::mesh, 0, mesh_number, 0.0);
  put(out, static_cast<std::uint32_t>(mesh.positions.size()));
  put(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  put(out, static_cast<std::uint32_t>(hierarchy == nullptr ? 1 : hierarchy->patches.size()));
  put(out, static_cast<std::uint32_t>(hierarchy == nullptr ? 1 : hierarchy->nodes.size()));
  put_surface(out, mesh);
  for (const std::uint32_t patch : patch_of_triangles(mesh, hierarchy)) put(out, patch);
  if (hierarchy != nullptr) {
    put_tree(out, *hierarchy);
  } else {
    for (const std::int32_t one : {0, -1, 0}) put(out, one);
  }
  return out;
}

std::string encode_level(std::uint32_t mesh_number, std::int32_t level, const TriangleMesh& mesh,
                         const ClodHierarchy& hierarchy) {
  std::vector<std::uint32_t> patch_of(mesh.triangles.size(), 0xffffffffu);
  std::vector<std::int32_t> nodes;
  for (const LevelPatch& contact : hierarchy.level_patches) {
    if (contact.level != level) continue;
    mark_patch(hierarchy, contact.patch, static_cast<std::uint32_t>(nodes.size()), patch_of);
    nodes.push_back(contact.patch.node);
  }
  std::string out;
  put_header(out, MessageKind::level, static_cast<std::uint16_t>(level), mesh_number, 0.0);
  put(out, static_cast<std::uint32_t>(mesh.positions.size()));
  put(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  put(out, static_cast<std::uint32_t>(nodes.size()));
  put(out, std::uint32_t{0});
  put_surface(out, mesh);
  for (const std::uint32_t patch : patch_of) put(out, patch);
  for (const std::int32_t node : nodes) put(out, node);
  return out;
}

std::string encode_divided(std::uint32_t mesh_number, const TriangleMesh& fine,
                           const TriangleMesh& coarse, int divisions,
                           const ClodHierarchy& hierarchy) {
  const std::vector<std::uint32_t> patch_of = patch_of_triangles(coarse, &hierarchy);
  std::string out;
  put_header(out, MessageKind::relief, 0, mesh_number, 0.0);
  put(out, static_cast<std::uint32_t>(fine.positions.size()));
  put(out, static_cast<std::uint32_t>(fine.triangles.size()));
  put(out, static_cast<std::uint32_t>(hierarchy.patches.size()));
  put(out, std::uint32_t{0});
  put_surface(out, fine);
  for (const std::uint32_t patch : patch_of)
    for (int k = 0; k < divisions * divisions; ++k) put(out, patch);
  return out;
}

std::string encode_channels(std::span<const ChannelRow> rows) {
  std::string out;
  const double begin = rows.empty() ? 0.0 : rows.front().time;
  put_header(out, MessageKind::channels, kChannels, rows.size(), begin);
  for (const ChannelRow& row : rows) {
    put_float(out, row.time - begin);
    for (const float value : row.values) put_float(out, static_cast<double>(value));
  }
  return out;
}

std::string encode_snapshot(const Snapshot& s) {
  std::string out;
  const std::size_t contacts = std::min(s.contacts.size(), kViewedContacts);
  const std::size_t clusters = std::min(s.clusters.size(), kMostClusters);
  const std::size_t rows = std::min(s.rows.size(), kViewedRows);
  put_header(out, MessageKind::snapshot, s.bits, contacts, s.time);
  put(out, static_cast<double>(s.frame));
  put_fields(out, s);
  put(out, static_cast<std::uint32_t>(clusters));
  put(out, counted(s.found));
  put(out, counted(s.dropped));
  put(out, counted(s.front));
  put(out, static_cast<std::uint32_t>(s.fault));
  put(out, static_cast<std::uint32_t>(rows));
  for (const ViewedContact& c : s.contacts.first(contacts)) put_contact(out, c);
  for (const ViewedCluster& c : s.clusters.first(clusters)) put_cluster(out, c);
  for (const ViewedRow& r : s.rows.first(rows)) put_row(out, r);
  return out;
}

DeviceMessage decode_device(std::string_view message) {
  DeviceMessage result;
  const auto refuse = [&](const std::string& why) {
    result.samples.clear();
    result.problem = why;
    return result;
  };
  if (message.size() < kHeader) return refuse("a binary message has at least 16 bytes");
  if (get<std::uint8_t>(message, 0) != static_cast<std::uint8_t>(MessageKind::device))
    return refuse("unknown binary message, expected type 32");
  if (get<std::uint8_t>(message, 1) != kLayout) return refuse("unknown layout, expected 1");
  const std::size_t count = get<std::uint32_t>(message, 4);
  if (count < 1 || count > kMostSamples) return refuse("expected 1 to 64 samples");
  if (message.size() != kHeader + count * kSampleBytes)
    return refuse("the length does not fit the number of samples");
  result.sent = get<double>(message, 8);
  if (!std::isfinite(result.sent)) return refuse("a number is not finite");
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeader + i * kSampleBytes;
    WebSample sample;
    sample.time = get<double>(message, at);
    for (int k = 0; k < 3; ++k) {
      sample.pose.position[k] = get<float>(message, at + 8 + 4 * static_cast<std::size_t>(k));
    }
    for (int k = 0; k < 4; ++k) {
      sample.pose.orientation.coeffs()[k] =
          get<float>(message, at + 20 + 4 * static_cast<std::size_t>(k));
    }
    sample.buttons = get<std::uint32_t>(message, at + 36);
    if (std::string why = wrong_with(sample); !why.empty()) return refuse(why);
    if (i > 0 && sample.time < result.samples.back().time)
      return refuse("the browser's clock runs backwards");
    sample.pose.orientation.normalize();
    result.samples.push_back(sample);
  }
  return result;
}

std::optional<std::string_view> decode_upload(std::string_view message) {
  if (message.size() < kHeader ||
      get<std::uint8_t>(message, 0) != static_cast<std::uint8_t>(MessageKind::upload) ||
      get<std::uint8_t>(message, 1) != kLayout ||
      get<std::uint32_t>(message, 4) != message.size() - kHeader)
    return std::nullopt;
  return message.substr(kHeader);
}

std::string encode_device(double sent, std::span<const WebSample> samples) {
  std::string out;
  put_header(out, MessageKind::device, 0, samples.size(), sent);
  for (const WebSample& sample : samples) {
    put(out, sample.time);
    put_pose(out, sample.pose);
    put(out, sample.buttons);
  }
  return out;
}

}  // namespace thigma::live
