#include "experiments/common/contact_profile.h"

#include <cmath>
#include <cstdio>

#include "experiments/common/statistics.h"

#include "thigma/math/quantile.h"

namespace thigma::experiments {
namespace {

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g %%", 100.0 * share);
  return text;
}

std::string name_of(double threshold) { return "s0 = " + percent(threshold); }

constexpr double kCurvatureBand = 50.0;  // what is compared of the second derivative [Hz]

std::vector<double> curvature(const Profile& p, double step) {
  return second_derivative(low_pass(p.force_size, step, kCurvatureBand), step);
}

bool is_of_text(const Setting& s) { return s.name.find("; ") == std::string::npos; }

void cut_profile(Profile& p, const Span& span) {
  auto cut_vectors = [&](std::vector<Vec3>& v) {
    v = {v.begin() + static_cast<std::ptrdiff_t>(span.begin),
         v.begin() + static_cast<std::ptrdiff_t>(span.end)};
  };
  cut_vectors(p.force);
  cut_vectors(p.torque);
  for (std::vector<double>* v : {&p.force_size, &p.cpu, &p.front, &p.tests, &p.contacts,
                                 &p.mandatory, &p.unrefined, &p.level, &p.depth, &p.bound}) {
    *v = cut(*v, span);
  }
}

std::vector<double> components(const std::vector<Vec3>& v) {
  std::vector<double> flat;
  for (const Vec3& x : v) flat.insert(flat.end(), {x.x(), x.y(), x.z()});
  return flat;
}

// After x -> scale x + constant vector, by least squares.
double fitted_error(const std::vector<Vec3>& x, const std::vector<Vec3>& y) {
  Vec3 mean_x = Vec3::Zero(), mean_y = Vec3::Zero();
  const double n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x).squaredNorm();
    xy += (x[i] - mean_x).dot(y[i] - mean_y);
  }
  const double scale = xx > 0.0 ? xy / xx : 0.0;
  std::vector<Vec3> fitted;
  for (const Vec3& v : x) fitted.push_back(scale * (v - mean_x) + mean_y);
  return relative_error(components(fitted), components(y));
}

plot::Panel time_panel(const std::string& title, const std::string& label, bool is_log) {
  return {.title = title,
          .x = {.label = "time in contact [ms]"},
          .y = {.label = label, .is_log = is_log}};
}

double time_by_front_from(const ProfileStudy& study, std::size_t first) {
  std::vector<double> fronts, times;
  for (std::size_t k = first; k < study.settings.size(); ++k) {
    if (!is_of_text(study.settings[k])) continue;
    fronts.push_back(mean(study.profiles[k].front));
    times.push_back(mean(study.profiles[k].cpu));
  }
  return proportional_r_squared(fronts, times);
}

/// data.csv (a row a frame and setting) and sweep.csv (a row a setting).
std::vector<Table> profile_tables(const ProfileStudy& study) {
  Table frames{.columns = {"setting", "s0", "time [s]", "force [N]", "force x [N]", "force y [N]",
                           "force z [N]", "torque x [N m]", "torque y [N m]", "torque z [N m]",
                           "query CPU [s]", "front", "tests", "contacts", "mean level",
                           "largest bound [m]"}};
  Table sweep{
      .name = "sweep",
      .columns = {"setting", "s0", "force correlation", "curvature correlation", "force error",
                  "force error, fitted", "torque error", "torque error, fitted",
                  "query CPU p50 [s]", "query CPU p99 [s]", "query CPU variation", "front mean",
                  "tests mean", "contacts mean", "mean level", "front to force rank correlation"}};
  for (std::size_t k = 0; k < study.settings.size(); ++k) {
    const Setting& s = study.settings[k];
    const Profile& p = study.profiles[k];
    const Likeness& like = study.likeness[k];
    std::vector<double> levels;
    for (const double level : p.level) {
      if (std::isfinite(level)) levels.push_back(level);
    }
    for (std::size_t i = 0; i < p.force.size(); ++i) {
      add_row(frames, {s.name, s.threshold, static_cast<double>(i) * study.step, p.force_size[i],
                       p.force[i].x(), p.force[i].y(), p.force[i].z(), p.torque[i].x(),
                       p.torque[i].y(), p.torque[i].z(), p.cpu[i], p.front[i], p.tests[i],
                       p.contacts[i], p.level[i], p.bound[i]});
    }
    add_row(sweep, {s.name, s.threshold, like.correlation, like.curvature, like.force_error,
                    like.shape_error, like.torque_error, like.torque_shape_error,
                    sample_quantile(p.cpu, 0.5), sample_quantile(p.cpu, 0.99),
                    coefficient_of_variation(p.cpu), mean(p.front), mean(p.tests), mean(p.contacts),
                    mean(levels), rank_correlation(p.front, p.force_size)});
  }
  return {frames, sweep};
}

/// Force, query time and front over time, as the source draws them, for the settings of the text.
plot::Figure profile_figure(const ProfileStudy& study, const std::string& title,
                            const std::string& note) {
  plot::Figure figure{.title = title, .note = note};
  figure.panels = {time_panel("Contact force", "force [N]", false),
                   time_panel("Contact query", "CPU time [us]", true),
                   time_panel("Front of the bounding volume test tree", "node pairs", true)};
  int color = 6;  // exact is black
  for (std::size_t k = 0; k < study.settings.size(); ++k) {
    if (!is_of_text(study.settings[k])) continue;
    const Profile& p = study.profiles[k];
    std::vector<double> time, microseconds;
    for (std::size_t i = 0; i < p.cpu.size(); ++i) {
      time.push_back(1e3 * static_cast<double>(i) * study.step);
      microseconds.push_back(1e6 * p.cpu[i]);
    }
    const std::vector<double>* values[] = {&p.force_size, &microseconds, &p.front};
    for (std::size_t panel = 0; panel < 3; ++panel) {
      figure.panels[panel].series.push_back({.label = study.settings[k].name,
                                             .x = time,
                                             .y = *values[panel],
                                             .color = color,
                                             .width = k == 0 ? 1.8 : 1.2});
    }
    color = k == 0 ? 0 : color + (color == 5 ? 2 : 1);
  }
  return figure;
}

Claim unless_known(Claim claim, const Known& known) {
  return known.reason.empty() ? claim : known_not_to(std::move(claim), known);
}

std::vector<Claim> common_claims(const ProfileFigure& figure, const Profile& exact,
                                 const Profile& coarse, const Likeness& like) {
  const std::string at = percent(figure.thresholds.back());
  return {
      unless_known(at_least("profile", "correlation of the force at " + at + " with the exact one",
                            like.correlation, 0.98),
                   figure.why_no_profile),
      unless_known(at_least("curvature", "the same of its second derivative, low-passed at 50 Hz",
                            like.curvature, 0.9),
                   figure.why_no_curvature),
      at_least("front",
               "times the front is smaller at " + at +
                   " than exact, means along the path; the source has " + figure.source_front,
               mean(exact.front) / mean(coarse.front), 10.0),
      stated(
          "speed-up",
          "mean query time exact over that at " + at + "; the source has " + figure.source_speed_up,
          mean(exact.cpu) / mean(coarse.cpu))};
}

}  // namespace

std::vector<Setting> profile_settings(const std::vector<double>& thresholds, double main) {
  std::vector<Setting> settings = {{"exact", 0.0, as_in_text(0.0)}};
  for (const double s0 : thresholds) settings.push_back({name_of(s0), s0, as_in_text(s0)});
  const std::string name = name_of(main);
  Resolution one_ring = as_in_text(main), capped = as_in_text(main), plain = as_in_text(main),
             least = as_in_text(main), by_patch = as_in_text(main);
  one_ring.reading = SupportReading::one_ring;
  capped.deviation_cap = 0.02;
  plain.interpolates = false;
  least.area = SupportArea::smaller;
  by_patch.reading = SupportReading::patch;
  settings.push_back({name + "; one-ring D", main, one_ring});
  settings.push_back({name + "; smaller D", main, least});
  settings.push_back({name + "; cap 2 %", main, capped});
  settings.push_back({name + "; no interpolation", main, plain});
  settings.push_back({name + "; one D a patch", main, by_patch});
  return settings;
}

Likeness compare(const Profile& profile, const Profile& reference, double step) {
  Likeness like;
  like.correlation = correlation(profile.force_size, reference.force_size);
  like.curvature = 2.0 * kCurvatureBand * step < 1.0
                       ? correlation(curvature(profile, step), curvature(reference, step))
                       : std::nan("");
  like.force_error = relative_error(components(profile.force), components(reference.force));
  like.torque_error = relative_error(components(profile.torque), components(reference.torque));
  like.shape_error = fitted_error(profile.force, reference.force);
  like.torque_shape_error = fitted_error(profile.torque, reference.torque);
  return like;
}

ProfileStudy study_profile(const Context& context, const Pair& pair, const Path& path,
                           const PenaltyParams& gains, const std::vector<Setting>& settings,
                           int repeats) {
  ProfileStudy study;
  study.step = path.step;
  study.settings = settings;
  for (const Setting& s : settings) {
    tell(context, pair.name + ": " + s.name);
    study.profiles.push_back(replay(pair, path, s.resolution, gains, repeats));
  }
  const Span span = in_contact(study.profiles.front());
  for (Profile& p : study.profiles) cut_profile(p, span);
  for (const Profile& p : study.profiles)
    study.likeness.push_back(compare(p, study.profiles.front(), study.step));
  return study;
}

double time_by_front(const ProfileStudy& study) { return time_by_front_from(study, 1); }

double time_by_front_with_exact(const ProfileStudy& study) { return time_by_front_from(study, 0); }

Outcome run_profile(const Context& context, const ProfileFigure& figure) {
  const Pair pair = scene_pair(*context.assets, figure.scene);
  const PenaltyParams gains = direct_gains(pair);
  const double main = figure.thresholds.back();
  HandScript hand = figure.hand(pair.radius);
  if (context.quick) hand.seconds = figure.quick_seconds;
  const Path path = record_path(pair, as_in_text(main), gains, hand);
  const ProfileStudy study = study_profile(
      context, pair, path, gains, profile_settings(figure.thresholds, main), context.quick ? 2 : 3);
  const std::size_t at_main = figure.thresholds.size();  // the first setting is exact
  const Profile &exact = study.profiles.front(), &coarse = study.profiles[at_main];
  Outcome outcome;
  outcome.tables = profile_tables(study);
  outcome.figure = profile_figure(study, figure.title,
                                  "path led at " + percent(main) +
                                      ", played back at the other thresholds; tolerance " +
                                      percent(kDirectTolerance) + " of the radius");
  outcome.claims = common_claims(figure, exact, coarse, study.likeness[at_main]);
  for (Claim& claim : figure.own_claims(exact, coarse, study))
    outcome.claims.push_back(std::move(claim));
  return outcome;
}

}  // namespace thigma::experiments
