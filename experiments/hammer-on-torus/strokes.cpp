#include "experiments/hammer-on-torus/strokes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/common/statistics.h"
#include "experiments/common/textured_session.h"

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"
#include "thigma/models/textured_parts.h"

namespace thigma::experiments::hammer_on_torus {
namespace {

/// What the hammer and the torus have over their coarse surfaces.
enum class Surface {
  coarse,  // nothing
  smooth,  // their fine surfaces without relief: the control
  relief,  // their fine surfaces
};
constexpr std::array<const char*, 3> kSurfaces = {"coarse", "smooth", "relief"};

/// What of the hammer lies on the torus.
enum class Touch {
  side,  // of the head, a cylinder across the tube
  face,  // of the head, a disc of 27 mm
};
constexpr std::array<const char*, 2> kTouches = {"side", "face"};

/// One run, over the part at constant speed.
struct Stroke {
  double speed = 0.0;                        // of the head around the ring [m/s]
  double mean_force = 0.0, deviation = 0.0;  // fed back [N]
  double band = 0.0;  // of the force between 20 and 300 Hz, root mean square [N]
  // the same within a tenth of the frequency at which the torus' waves pass [N]
  double at_waves = 0.0;
  // where between 0.6 and 1.6 times that frequency the force is strongest [Hz]
  double peak = 0.0;
  double waves = 0.0;               // that frequency [Hz]
  double faults = 0.0;              // safety events
  std::vector<double> time, force;  // [s, N]
};

constexpr double kInBand = 0.2;  // from this speed on the waves pass at 20 Hz and more [m/s]
constexpr double kRing = 0.060, kWaves = 40.0;  // of the torus: radius [m], ridges around it
constexpr double kDown = 0.6, kRest = 0.2;      // [s]
constexpr double kSpeedUp = 0.2;                // until the speed is constant [s]
constexpr double kGap = 0.004, kPress = 0.004;  // [m]

/// The head rests on its side, its axis across the tube: the side is 15 mm from its axis, the
/// tube's top 20 mm high.
void lay_on_side(SceneDescription& scene) {
  const double quarter = std::sqrt(0.5);
  scene.object.world_from_mesh.orientation = Quat(quarter, quarter, 0.0, 0.0);
  scene.object.world_from_mesh.position = Vec3(kRing, 0.0, 0.015 + 0.020 + kGap);
}

/// The way around the ring after the handle is down [rad].
double turned(double t, double speed) {
  const double since = std::max(t - kDown - kRest, 0.0), rate = speed / kRing;
  return since < kSpeedUp ? 0.5 * rate * since * since / kSpeedUp : rate * (since - 0.5 * kSpeedUp);
}

HapticTexture without_relief(const SceneObject& object, int texels) {
  std::vector<models::TexturedSheet> sheets = models::textured_part(object.textured_model->name);
  for (models::TexturedSheet& sheet : sheets) sheet.fine = sheet.smooth;
  return make_texture(models::make_textured_sheets(sheets, texels), object.name);
}

std::unique_ptr<TexturedSession> open_session(Touch touch, Surface surface, int texels) {
  const auto change = [&](SceneDescription& scene) {
    if (touch == Touch::side) lay_on_side(scene);
    for (SceneObject* o : {&scene.object, &scene.statics[0]}) o->textured_model->texels = texels;
  };
  std::function<HapticTexture(const SceneObject&)> make;
  if (surface == Surface::smooth)
    make = [texels](const SceneObject& object) { return without_relief(object, texels); };
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

Stroke stroke_at(TexturedSession& session, double speed, double seconds) {
  const Vec3 head = session.scene.object.world_from_mesh.position;
  const double begin = kDown + kRest + kSpeedUp + 0.1;
  const ScriptRun run = run_script(session, begin + seconds, [&](double t) {
    const double down = std::clamp(t / kDown, 0.0, 1.0);
    Pose pose;
    pose.orientation = rotation_from_vector(Vec3(0.0, 0.0, turned(t, speed)));
    pose.position = pose.orientation * head - head;
    pose.position.z() = -(kGap + kPress) * down * down * (3.0 - 2.0 * down);
    return pose;
  });
  Stroke stroke{.speed = speed};
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

void note(Touch touch, Surface surface, const Stroke& s, Table& table) {
  add_row(table, {std::string(kTouches[static_cast<std::size_t>(touch)]),
                  std::string(kSurfaces[static_cast<std::size_t>(surface)]), s.speed, s.waves,
                  s.mean_force, s.deviation, s.band, s.at_waves, s.peak, s.faults});
}

/// What the relief adds where its waves pass in the band, the worst of the strokes.
struct Added {
  // force between 20 and 300 Hz over that of the other surfaces
  double over_smooth = 1e9, over_coarse = 1e9;
  // what is more than on the smooth surface, over the mean force
  double of_mean = 1e9;
  double off = 0.0;     // of the strongest frequency from that of the waves
  double faults = 0.0;  // of all strokes

  void observe(const Stroke& coarse, const Stroke& smooth, const Stroke& relief) {
    faults += coarse.faults + smooth.faults + relief.faults;
    if (relief.speed < kInBand) return;
    over_smooth = std::min(over_smooth, relief.band / smooth.band);
    over_coarse = std::min(over_coarse, relief.band / coarse.band);
    const double more = relief.band * relief.band - smooth.band * smooth.band;
    of_mean = std::min(of_mean, std::sqrt(std::max(more, 0.0)) / relief.mean_force);
    off = std::max(off, std::fabs(relief.peak / relief.waves - 1.0));
  }
};

}  // namespace

void add_strokes(const Context& context, Outcome& outcome) {
  Table table{.name = "strokes",
              .columns = {"touch", "surface", "speed [m/s]", "waves pass at [Hz]", "mean force [N]",
                          "deviation [N]", "20 to 300 Hz [N]", "at the waves [N]",
                          "strongest at [Hz]", "safety events"}};
  plot::Panel panel{.title = "Side of the head around the torus at 200 mm/s",
                    .x = {.label = "time [s]"},
                    .y = {.label = "feedback force [N]"}};
  const std::vector<double> speeds =
      context.quick ? std::vector{kInBand, 0.3} : std::vector{0.006, 0.02, 0.1, kInBand, 0.3, 0.4};
  Added added;
  for (const Touch touch : {Touch::side, Touch::face}) {
    std::array<std::vector<Stroke>, 3> strokes;
    for (const Surface surface : {Surface::coarse, Surface::smooth, Surface::relief}) {
      const char* const name = kSurfaces[static_cast<std::size_t>(surface)];
      tell(context, std::string(kTouches[static_cast<std::size_t>(touch)]) + ", " + name);
      const auto session = open_session(touch, surface, context.quick ? 512 : 1024);
      for (const double speed : speeds) {
        if (context.quick && touch == Touch::face && speed > kInBand) continue;
        const Stroke& s = strokes[static_cast<std::size_t>(surface)].emplace_back(
            stroke_at(*session, speed, 1.0));
        note(touch, surface, s, table);
        if (touch == Touch::side && speed == kInBand)
          panel.series.push_back({.label = name, .x = s.time, .y = s.force});
      }
    }
    for (std::size_t i = 0; i < strokes[0].size(); ++i)
      added.observe(strokes[0][i], strokes[1][i], strokes[2][i]);
  }
  outcome.tables.push_back(std::move(table));
  outcome.figure.panels.push_back(panel);
  outcome.claims = {
      at_least("textured",
               "force between 20 and 300 Hz with relief over that on the same surfaces without, "
               "with the side "
               "and the face of the head at 200 mm/s and more, the least",
               added.over_smooth, 2.0),
      at_most("frequency",
              "strongest frequency off that at which the waves of the torus pass, the worst",
              added.off, 0.02),
      at_most("stroke-faults", "safety events of the strokes", added.faults, 0.0),
      stated("added", "what the relief adds there, over the mean force", added.of_mean),
      stated("facets", "as `textured`, over the coarse surfaces alone", added.over_coarse)};
}

}  // namespace thigma::experiments::hammer_on_torus
