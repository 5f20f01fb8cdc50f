#include "experiments/relief/ridges.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "thigma/clod/clod_asset.h"
#include "thigma/device/script.h"
#include "thigma/scene/load_scene.h"
#include "thigma/scene/scene_file.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::experiments::relief {
namespace {

constexpr double kPitch = 0.035;            // of the model [m]
constexpr double kWay = 0.2, kStart = 0.6;  // of the hand, and when it begins [m, s]
constexpr double kStep = 1e-3;

/// Height of the plate's fine surface over a place of it, by its texels.
class Plate {
 public:
  explicit Plate(const HapticTexture& texture) : texture_(texture) {
    for (const Vec3& p : texture.coarse.positions)
      low_ = low_.cwiseMin(p), high_ = high_.cwiseMax(p);
  }
  double height(double x, double y) const {
    const Vec2 at((x - low_.x()) / (high_.x() - low_.x()) * kLast,
                  (y - low_.y()) / (high_.y() - low_.y()) * kLast);
    const int i = std::clamp(static_cast<int>(at.x()), 0, kLast - 1),
              j = std::clamp(static_cast<int>(at.y()), 0, kLast - 1);
    const auto z = [&](int a, int b) { return static_cast<double>(texel_at(texture_, a, b).z); };
    const double s = at.x() - i, t = at.y() - j;
    return high_.z() + (1.0 - t) * ((1.0 - s) * z(i, j) + s * z(i + 1, j)) +
           t * ((1.0 - s) * z(i, j + 1) + s * z(i + 1, j + 1));
  }
  /// Height at which the points of a mesh rest on it, moved to x.
  double rest(const TriangleMesh& mesh, double x, double y) const {
    double most = -1.0;
    for (const Vec3& p : mesh.positions)
      most = std::max(most, height(x + p.x(), y + p.y()) - p.z());
    return most;
  }

 private:
  static constexpr int kLast = 1023;
  const HapticTexture& texture_;
  Vec3 low_ = Vec3::Constant(1.0), high_ = Vec3::Constant(-1.0);
};

/// How often values rise through their mean, between the first and the last time [1/frame].
double rate_of(const std::vector<double>& values, double& swing) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  swing = 0.5 * (*high - *low);
  const double mean = 0.5 * (*low + *high);
  double first = -1.0, last = -1.0;
  int count = 0;
  bool is_low = false;
  for (std::size_t i = 1; i < values.size(); ++i) {
    is_low = is_low || values[i] < mean - 0.3 * swing;
    if (!is_low || values[i] < mean) continue;
    is_low = false;
    const double at = static_cast<double>(i) - (values[i] - mean) / (values[i] - values[i - 1]);
    if (count++ == 0) first = at;
    last = at;
  }
  return (count - 1) / (last - first);
}

std::vector<TimedPose> stroke(double low, double speed) {
  std::vector<TimedPose> rows;
  for (int i = 0; i <= static_cast<int>((kStart + kWay / speed) / kStep); ++i) {
    const double t = kStep * i, in = std::clamp(t / 0.5, 0.0, 1.0);
    TimedPose row;
    row.time = t;
    row.pose.position = {speed * std::max(t - kStart, 0.0), 0.0, -low * in};
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

Felt feel_ridges(int every, double speed) {
  const double seconds = kStart + kWay / speed;
  SceneDescription description = read_scene("plate");
  description.contact.response = ResponseKind::constrained;
  description.contact.friction = {};
  description.object.world_from_mesh.position += Vec3(-0.1, 0.0, 0.0);
  const Scene scene = load_scene(std::move(description));
  SceneSession opened = open_session(scene, {.device = "null:", .duration = seconds});
  SessionConfig config = opened.config;
  const Vec3 start = config.world_from_body.position;
  const TriangleMesh& probe = scene.object->meshes.front();
  const Plate plate(*scene.static_textures[0][0]);
  const Pose& body_from_mesh = config.contact.body_from_mesh;
  TriangleMesh about_centre = probe;
  for (Vec3& p : about_centre.positions) p = transform_point(body_from_mesh, p);
  double low = 1.0, high = -1.0;
  for (int i = 0; i < 140; ++i) {
    const double rest = plate.rest(about_centre, -0.5 * kPitch + kPitch * i / 140.0, start.y());
    low = std::min(low, rest), high = std::max(high, rest);
  }
  // As far below the lowest rest as ridges are high.
  const double scale = config.haptic.workspace.motion_scale;
  std::vector<TimedPose> rows = stroke(start.z() - low + 0.5 * (high - low), speed);
  for (TimedPose& row : rows) row.pose.position /= scale;
  const std::unique_ptr<HapticDevice> device = make_script_device(std::move(rows));
  config.contact_every = every;
  config.haptic.device = device->limits();
  Felt felt;
  std::vector<double> force;
  Vec3 last = Vec3::Zero();
  const auto look = [&](const HapticSample& s) {
    if (s.time < kStart + 0.02 / speed) return;
    if (!force.empty())
      felt.largest_step = std::max(felt.largest_step, (s.command.force - last).norm());
    last = s.command.force;
    force.push_back(s.command.force.z());
  };
  const SessionSummary summary = run_lockstep(config, *device, {look, {}, {}});
  felt.is_stable = summary.end == SessionEnd::duration;
  double swing = 0.0;
  felt.rate = rate_of(force, swing) / kStep * kPitch / speed;
  felt.decibel =
      20.0 * std::log10(swing / (config.haptic.coupling.linear_stiffness * 0.5 * (high - low)));
  return felt;
}

}  // namespace thigma::experiments::relief
