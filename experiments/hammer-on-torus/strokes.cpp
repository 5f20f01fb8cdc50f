#include "experiments/hammer-on-torus/strokes.h"

#include <algorithm>
#include <cmath>

#include "experiments/common/statistics.h"
#include "scenes/textured_parts.h"

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments::hammer_on_torus {
namespace {

constexpr double kRing = 0.060, kWaves = 40.0;   // of the torus: radius [m], ridges around it
constexpr double kDown = 0.6, kRest = 0.2;       // [s]
constexpr double kSpeedUp = 0.2;                 // until the speed is constant [s]
constexpr double kGap = 0.004, kPress = 0.004;   // [m]

/// The head rests on its side, its axis across the tube: the side is 15 mm from its axis, the tube's top 20 mm high.
void lay_on_side(scenes::SceneDescription& scene) {
  const double quarter = std::sqrt(0.5);
  scene.object.world_from_mesh.orientation = Quat(quarter, quarter, 0.0, 0.0);
  scene.object.world_from_mesh.position = Vec3(kRing, 0.0, 0.015 + 0.020 + kGap);
}

/// The way around the ring after the handle is down [rad].
double turned(double t, double speed) {
  const double since = std::max(t - kDown - kRest, 0.0), rate = speed / kRing;
  return since < kSpeedUp ? 0.5 * rate * since * since / kSpeedUp : rate * (since - 0.5 * kSpeedUp);
}

HapticTexture without_relief(const scenes::SceneObject& object, int texels) {
  std::vector<scenes::TexturedSheet> sheets = scenes::textured_part(object.textured_model->name);
  for (scenes::TexturedSheet& sheet : sheets) sheet.fine = sheet.smooth;
  return make_texture(scenes::make_textured_sheets(sheets, texels), object.name);
}

std::unique_ptr<TexturedSession> open_session(Touch touch, Surface surface, int texels) {
  const auto change = [&](scenes::SceneDescription& scene) {
    if (touch == Touch::side) lay_on_side(scene);
    for (scenes::SceneObject* o : {&scene.object, &scene.statics[0]}) o->textured_model->texels = texels;
  };
  std::function<HapticTexture(const scenes::SceneObject&)> make;
  if (surface == Surface::smooth)
    make = [texels](const scenes::SceneObject& object) { return without_relief(object, texels); };
  auto session = textured_session("hammer_on_torus", surface != Surface::coarse, change, make);
  // Held at the head: pressed at its centre of mass, far along the handle, it would tip.
  session->config.haptic.grasp_point = session->config.contact.body_from_mesh.position;
  return session;
}

/// The frequency between two at which a signal is strongest, under a Hann window.
double strongest(std::span<const double> x, double low, double high) {
  const double middle = mean(x);
  const auto count = static_cast<double>(x.size());
  double best = 0.0, most = -1.0;
  for (double f = low; f <= high; f += 0.002 * (low + high)) {
    double c = 0.0, s = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double window = 1.0 - cosine(2.0 * kPi * static_cast<double>(i) / count);
      const SinCos w = sin_cos(2.0 * kPi * f * 1e-3 * static_cast<double>(i));
      c += window * (x[i] - middle) * w.cos;
      s += window * (x[i] - middle) * w.sin;
    }
    if (c * c + s * s <= most) continue;
    most = c * c + s * s;
    best = f;
  }
  return best;
}

}  // namespace

const char* name_of(Surface surface) {
  return surface == Surface::coarse ? "coarse" : surface == Surface::smooth ? "smooth" : "relief";
}
const char* name_of(Touch touch) { return touch == Touch::face ? "face" : "side"; }

Stroke stroke_torus(Touch touch, Surface surface, double speed, double seconds, int texels) {
  const auto session = open_session(touch, surface, texels);
  const Vec3 head = session->scene.object.world_from_mesh.position;
  const double begin = kDown + kRest + kSpeedUp + 0.1;
  const ScriptRun run = run_script(*session, begin + seconds, [&](double t) {
    const double down = std::clamp(t / kDown, 0.0, 1.0);
    Pose pose;
    pose.orientation = rotation_from_vector(Vec3(0.0, 0.0, turned(t, speed)));
    pose.position = pose.orientation * head - head;
    pose.position.z() = -(kGap + kPress) * down * down * (3.0 - 2.0 * down);
    return pose;
  });
  Stroke stroke{.touch = touch, .surface = surface, .speed = speed};
  for (const HapticSample& s : run.frames) {
    if (s.time < begin) continue;
    stroke.time.push_back(s.time - begin);
    stroke.force.push_back(s.feedback.force.norm());
  }
  stroke.waves = kWaves * speed / (2.0 * kPi * kRing);
  stroke.mean_force = mean(stroke.force);
  stroke.deviation = standard_deviation(stroke.force);
  stroke.band = band_level(stroke.force, 1e-3, 20.0, 300.0);
  stroke.at_waves = band_level(stroke.force, 1e-3, 0.9 * stroke.waves, 1.1 * stroke.waves);
  stroke.peak = strongest(stroke.force, 0.6 * stroke.waves, 1.6 * stroke.waves);
  stroke.faults = static_cast<double>(run.summary.safety_events.size());
  return stroke;
}

}  // namespace thigma::experiments::hammer_on_torus
