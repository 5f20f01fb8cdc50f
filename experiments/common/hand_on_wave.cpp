#include "experiments/common/hand_on_wave.h"

#include <algorithm>
#include <cmath>

#include "reference/offset_surface.h"
#include <Eigen/QR>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/loop/contact_step.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/shapes.h"
#include "thigma/response/texture_contacts.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::experiments {
namespace {

constexpr int kPlaces = 1000;  // of the closed form, over a wavelength

/// A square of a few wavelengths with the wave along x.
HapticTexture wave_square(double side, double wavelength, double amplitude, int texels) {
  TextureSource source;
  const double h = 0.5 * side, last = texels - 1.0;
  source.coarse = {{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  source.corners = {{Vec2(0, 0), Vec2(last, 0), Vec2(last, last)},
                    {Vec2(0, 0), Vec2(last, last), Vec2(0, last)}};
  source.width = source.height = texels;
  for (int j = 0; j < texels; ++j) {
    for (int i = 0; i < texels; ++i) {
      const double x = side * (i / last - 0.5);
      source.texels.push_back(
          {0.0f, 0.0f, static_cast<float>(amplitude * cosine(2.0 * kPi * x / wavelength))});
    }
  }
  return make_texture(std::move(source), "wave");
}

double slope_at(const SlopeTable& table, double u) {
  const double count = static_cast<double>(table.slopes.size());
  const double place = (u / table.wavelength - std::floor(u / table.wavelength)) * count;
  const std::size_t i = std::min(static_cast<std::size_t>(place), table.slopes.size() - 1);
  const double share = place - static_cast<double>(i);
  return (1.0 - share) * table.slopes[i] + share * table.slopes[(i + 1) % table.slopes.size()];
}

std::vector<double> spacings(bool is_quick) {
  const int count = is_quick ? 13 : 25;
  std::vector<double> list;
  // Equal ratios from 0.4 to 12 mm, without a power function: 30^(k / (count - 1)) by exponentials.
  constexpr double kLog30 = 3.4011973816621555;
  for (int k = 0; k < count; ++k) list.push_back(4e-4 * exponential(kLog30 * k / (count - 1)));
  return list;
}

void find_peak(Roughness& curve) {
  const auto most = std::max_element(curve.acceleration.begin(), curve.acceleration.end());
  const std::size_t i = static_cast<std::size_t>(most - curve.acceleration.begin());
  curve.peak = *most;
  curve.peak_spacing = curve.spacing[i];
  if (i == 0 || i + 1 == curve.spacing.size()) return;
  const double a = std::log(curve.acceleration[i - 1]), b = std::log(curve.acceleration[i]),
               c = std::log(curve.acceleration[i + 1]);
  const double way = 0.5 * (a - c) / (a - 2.0 * b + c);
  curve.peak_spacing *= std::exp(way * std::log(curve.spacing[i + 1] / curve.spacing[i]));
}

}  // namespace

SlopeTable exact_slopes(const WaveStroke& stroke, double wavelength) {
  SlopeTable table{wavelength, {}};
  for (int i = 0; i < kPlaces; ++i)
    table.slopes.push_back(
        disk_on_wave(0.5 * stroke.diameter, stroke.amplitude, wavelength, wavelength * i / kPlaces)
            .slope);
  return table;
}

SlopeTable pipeline_slopes(const WaveStroke& stroke, double wavelength, int places) {
  const double radius = 0.5 * stroke.diameter, side = 4.0 * std::max(wavelength, radius);
  const TriangleMesh mesh = make_ball(radius, 24);
  const HapticTexture wave = wave_square(side, wavelength, stroke.amplitude, 1024);
  const HapticTexture smooth = make_plain_texture(mesh, "ball");
  const ClodHierarchy ball = build_exact_hierarchy(mesh),
                      square = build_exact_hierarchy(wave.coarse);
  ContactWorld world;
  world.object = &ball;
  world.scene = {{&square, Pose{}}};
  world.tolerance = 0.02 * radius;
  world.max_clusters = 1;
  world.textures.object = make_textured_body(smooth, ball);
  world.textures.scene = {make_textured_body(wave, square)};
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  SlopeTable table{wavelength, {}};
  ContactSample sample;
  for (int i = 0; i < places; ++i) {
    StampedBody at;
    const double u = wavelength * i / places;
    const double rest = disk_on_wave(radius, stroke.amplitude, wavelength, u).height;
    at.state.position = {u, 0.0, radius + rest - 0.01 * radius};
    contact_step(world, at, scratch, sample);
    const bool is_found = !sample.model.depths.empty();
    table.slopes.push_back(is_found ? sample.model.depths[0].linear.x() : std::nan(""));
  }
  return table;
}

double largest_acceleration(const WaveStroke& s, const SlopeTable& table) {
  const double damping = 2.0 * s.damping_ratio * std::sqrt(s.stiffness * s.mass);
  const auto acceleration = [&](double t, double u, double rate) {
    return (s.stiffness * (s.speed * t - u) + damping * (s.speed - rate) -
            s.normal_force * slope_at(table, u)) /
           s.mass;
  };
  constexpr double kStep = 1e-4, kSeconds = 2.0;
  double u = 0.0, rate = s.speed, largest = 0.0;
  for (int i = 0; i < static_cast<int>(kSeconds / kStep); ++i) {
    const double t = kStep * i, a = acceleration(t, u, rate);
    const double middle_rate = rate + 0.5 * kStep * a;
    const double b = acceleration(t + 0.5 * kStep, u + 0.5 * kStep * rate, middle_rate);
    u += kStep * middle_rate;
    rate += kStep * b;
    if (t >= 0.5 * kSeconds) largest = std::max(largest, a);
  }
  return largest;
}

std::vector<Roughness> roughness_curves(const Context& context, std::vector<Roughness> curves,
                                        bool through_pipeline) {
  const int places = context.quick ? 120 : 360;
  std::vector<SlopeTable> tables;  // of the last probe and wave: force and speed do not change them
  WaveStroke last{.amplitude = 0.0};
  for (Roughness& curve : curves) {
    const WaveStroke& stroke = curve.stroke;
    if (stroke.diameter != last.diameter || stroke.amplitude != last.amplitude) {
      tables.clear();
      for (const double spacing : spacings(context.quick))
        tables.push_back(through_pipeline ? pipeline_slopes(stroke, spacing, places)
                                          : exact_slopes(stroke, spacing));
      last = stroke;
    }
    for (const SlopeTable& table : tables) {
      curve.spacing.push_back(table.wavelength);
      curve.acceleration.push_back(largest_acceleration(stroke, table));
    }
    find_peak(curve);
    tell(context, curve.label + (through_pipeline ? ", pipeline" : ", closed form"));
  }
  return curves;
}

double quadratic_fit(const Roughness& curve) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < curve.spacing.size(); ++i) {
    if (curve.spacing[i] < 5e-4 || curve.spacing[i] > 5e-3) continue;
    x.push_back(std::log(curve.spacing[i]));
    y.push_back(std::log(curve.acceleration[i]));
  }
  const Eigen::Index n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd basis(n, 3);
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double at = x[static_cast<std::size_t>(i)];
    basis.row(i) << 1.0, at, at * at;
    values[i] = y[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd fitted = basis * basis.colPivHouseholderQr().solve(values);
  const double about = (values.array() - values.mean()).square().sum();
  return 1.0 - (values - fitted).squaredNorm() / about;
}

Outcome run_roughness(const Context& context, const std::string& title,
                      const std::vector<Roughness>& curves,
                      void (*add_claims)(const std::string& suffix, const std::string& how,
                                         const std::vector<Roughness>& curves, Outcome& outcome)) {
  const std::vector<Roughness> exact = roughness_curves(context, curves, false),
                               pipeline = roughness_curves(context, curves, true);
  Outcome outcome;
  outcome.tables = {{.name = "data",
                     .columns = {"slopes", "curve", "diameter [m]", "normal force [N]",
                                 "speed [m/s]", "spacing [m]", "largest acceleration [m/s^2]"}}};
  outcome.figure = {.title = title, .columns = 2};
  const std::vector<Roughness>* both[] = {&exact, &pipeline};
  const char* names[] = {"closed form", "pipeline"};
  for (std::size_t k = 0; k < 2; ++k) {
    plot::Panel panel{.title = names[k],
                      .x = {.label = "spacing [mm]", .is_log = true},
                      .y = {.label = "largest acceleration [m/s^2]", .is_log = true}};
    for (const Roughness& curve : *both[k]) {
      plot::Series series{.label = curve.label};
      for (std::size_t i = 0; i < curve.spacing.size(); ++i) {
        add_row(outcome.tables[0], {std::string(names[k]), curve.label, curve.stroke.diameter,
                                    curve.stroke.normal_force, curve.stroke.speed, curve.spacing[i],
                                    curve.acceleration[i]});
        series.x.push_back(1e3 * curve.spacing[i]);
        series.y.push_back(curve.acceleration[i]);
      }
      panel.series.push_back(series);
    }
    outcome.figure.panels.push_back(panel);
  }
  add_claims("", "closed form: ", exact, outcome);
  add_claims("-pipeline", "through the contact step: ", pipeline, outcome);
  return outcome;
}

double acceleration_at(const Roughness& curve, double spacing) {
  for (std::size_t i = 1; i < curve.spacing.size(); ++i) {
    if (curve.spacing[i] < spacing && i + 1 < curve.spacing.size()) continue;
    const double share = std::log(spacing / curve.spacing[i - 1]) /
                         std::log(curve.spacing[i] / curve.spacing[i - 1]);
    return std::exp((1.0 - share) * std::log(curve.acceleration[i - 1]) +
                    share * std::log(curve.acceleration[i]));
  }
  return std::nan("");
}

}  // namespace thigma::experiments
