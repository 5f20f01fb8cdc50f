// Fig. 4.16: what 500 frames of a file that scrapes a CAD part cost: the query, the textures, the
// whole, and the contacts.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/statistics.h"
#include "experiments/common/textured_session.h"

#include "thigma/depth/depth_gradient.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace fig_4_16 {
namespace {

constexpr int kMost = 7;                     // contacts a frame, the text: "as many as 7"
constexpr int kContactEvery = 5;             // haptic frames: 200 Hz, the upper of the text's rates
constexpr int kFrames = 500;                 // as the text shows
constexpr double kDown = 1.0, kGap = 0.004;  // [s, m] of the scene
// of the boss; of the file from its middle; where it is held [m]
constexpr double kRim = 0.018, kEnd = 0.100, kHeld = 0.090;

/// A corner of the file's end scrapes over the rim of the boss, further in and less, and rocks:
/// places that touch come and go.
Pose pose_at(double t) {
  const auto wave = [&](double hertz) {
    return sine(2.0 * kPi * hertz * std::max(t - kDown, 0.0));
  };
  const double down = std::clamp(t / kDown, 0.0, 1.0);
  Pose pose;
  pose.orientation =
      rotation_from_vector(Vec3(0.04 * wave(0.9), 0.03 * wave(1.3), 0.6 + 0.2 * wave(0.7)));
  pose.position.x() = -0.002 + 0.005 * wave(0.8);
  pose.position.y() = 0.014 + 0.004 * wave(1.1);
  pose.position.z() = -(kGap + 0.001) * down * down * (3.0 - 2.0 * down) + 0.001 * wave(1.7);
  return pose;
}

/// One contact frame.
struct Frame {
  // [s]; convex patches near each other; those with a depth
  double time = 0.0, pairs = 0.0, contacts = 0.0;
  double query = 0.0, texture = 0.0;  // CPU time [s]
  double total() const { return query + texture; }
};

/// The session with a gradient: the least times of some runs, which are alike in all but those.
std::vector<Frame> record(const Context& context, GradientKind gradient) {
  const auto session = textured_session("file_on_cad", true, [&](SceneDescription& scene) {
    scene.contact.max_clusters = kMost;
    scene.contact.texture.gradient = gradient;
    scene.object.world_from_mesh.position.x() = kRim + kEnd;
    if (!context.quick) return;
    for (SceneObject* o : {&scene.object, &scene.statics[0]}) o->textured_model->texels = 512;
  });
  session->config.contact_every = kContactEvery;
  session->config.haptic.grasp_point += Vec3(0.0, 0.0, -kHeld);  // near its end
  std::vector<Frame> frames;
  for (int repeat = 0; repeat < (context.quick ? 2 : 6); ++repeat) {
    const ScriptRun run = run_script(*session, kDown + 1e-3 * kContactEvery * kFrames, pose_at);
    std::size_t i = 0;
    for (const ContactSample& s : run.contacts) {
      if (s.time < kDown) continue;
      const double texture = s.step_cpu - s.query_cpu;
      if (repeat == 0)
        frames.push_back({s.time - kDown, static_cast<double>(s.contacts),
                          static_cast<double>(s.model.depths.size()), s.query_cpu, texture});
      Frame& frame = frames[i++];
      frame.query = std::min(frame.query, s.query_cpu);
      frame.texture = std::min(frame.texture, texture);
    }
  }
  return frames;
}

std::vector<double> column(const std::vector<Frame>& frames, double (*of)(const Frame&)) {
  std::vector<double> values;
  for (const Frame& frame : frames) values.push_back(of(frame));
  return values;
}

plot::Panel draw_times(const std::vector<Frame>& frames) {
  plot::Panel panel{.title = "A frame, gradient by central differences",
                    .x = {.label = "time [s]"},
                    .y = {.label = "CPU time [ms]", .low = 0.0},
                    .series = {{.label = "query"}, {.label = "textures"}, {.label = "total"}}};
  for (const Frame& f : frames) {
    const double values[] = {f.query, f.texture, f.total()};
    for (std::size_t k = 0; k < 3; ++k) {
      panel.series[k].x.push_back(f.time);
      panel.series[k].y.push_back(1e3 * values[k]);
    }
  }
  return panel;
}

plot::Panel draw_contacts(const std::vector<Frame>& frames) {
  plot::Panel panel{.title = "Contacts",
                    .x = {.label = "time [s]"},
                    .y = {.label = "clusters", .low = 0.0},
                    .series = {{.mark = plot::Mark::steps, .color = 3}}};
  for (const Frame& f : frames) {
    panel.series[0].x.push_back(f.time);
    panel.series[0].y.push_back(f.contacts);
  }
  return panel;
}

/// How the textures' time grows with the contacts.
struct Growth {
  // R^2 of a line through the mean times of the frames with 0, 1, 2, .. contacts
  double of_means = 0.0;
  double of_frames = 0.0;  // and of one through all frames
  // correlation of the time with the pairs, among frames with as many contacts as there may be
  double by_pairs = 0.0;
  double slope = 0.0;  // of the first line [s]
};

Growth growth_of(const std::vector<Frame>& frames) {
  std::vector<double> counts, means, most_pairs, most_times;
  for (int count = 0; count <= kMost; ++count) {
    std::vector<double> times;
    for (const Frame& f : frames) {
      if (f.contacts != count) continue;
      times.push_back(f.texture);
      if (count < kMost) continue;
      most_pairs.push_back(f.pairs);
      most_times.push_back(f.texture);
    }
    constexpr std::size_t kEnough = 5;  // frames
    if (times.size() < kEnough) continue;
    counts.push_back(count);
    means.push_back(mean(times));
  }
  const LineFit means_fit = fit_line(counts, means);
  const LineFit frames_fit = fit_line(column(frames, [](const Frame& f) { return f.contacts; }),
                                      column(frames, [](const Frame& f) { return f.texture; }));
  return {counts.size() < 6 ? std::nan("") : means_fit.r_squared, frames_fit.r_squared,
          correlation(most_pairs, most_times), means_fit.slope};
}

/// What there is to state of a session beside the source.
std::vector<Claim> describe(const std::string& name, const std::vector<Frame>& frames) {
  const Growth growth = growth_of(frames);
  std::vector<double> total;
  for (const Frame& f : frames)
    if (f.contacts > 0.0) total.push_back(f.total());
  return {stated("per-contact-" + name, "CPU time of one more contact, " + name, growth.slope, "s"),
          stated("linear-frames-" + name, "R^2 of a line through all frames, " + name,
                 growth.of_frames),
          stated("by-pairs-" + name,
                 "why frames scatter about it: correlation of the time with the pairs of patches "
                 "in the contacts, frames of seven",
                 growth.by_pairs),
          stated("rate-" + name,
                 "frames a second of CPU time, the slowest, " + name + "; the source's 100 to 200",
                 1.0 / *std::max_element(total.begin(), total.end()), "Hz"),
          stated("rate-mean-" + name, "the same, of the mean frame with a contact",
                 1.0 / mean(total), "Hz")};
}

/// The session that the text shows.
std::vector<Claim> describe_contacts(const std::vector<Frame>& frames) {
  const auto pairs = column(frames, [](const Frame&f) { return f.pairs; }),
             contacts = column(frames, [](const Frame&f) { return f.contacts; }),
             query = column(frames, [](const Frame&f) { return f.query; });
  return {
      at_least("contacts", "most contacts in a frame; the source's 7",
               *std::max_element(contacts.begin(), contacts.end()), kMost),
      at_most("fewest", "fewest contacts in a frame: they come and go",
              *std::min_element(contacts.begin(), contacts.end()), 1.0),
      stated("pairs", "pairs of convex patches near each other, mean; the source's 104",
             mean(pairs)),
      stated("pairs-most", "the same, most", *std::max_element(pairs.begin(), pairs.end())),
      stated("query", "largest CPU time of the query between the coarse models; the source's 2 ms",
             *std::max_element(query.begin(), query.end()), "s")};
}

}  // namespace
}  // namespace fig_4_16

Outcome run_fig_4_16(const Context& context) {
  using namespace fig_4_16;
  constexpr GradientKind kKinds[] = {GradientKind::central_differences,
                                     GradientKind::smoothed_envelope};
  Outcome outcome;
  outcome.tables = {{.name = "data",
                     .columns = {"gradient", "time [s]", "pairs of patches", "contacts",
                                 "query [s]", "textures [s]", "total [s]"}}};
  plot::Panel over{.title = "Textures over contacts",
                   .x = {.label = "contacts", .low = -0.3, .high = 7.3},
                   .y = {.label = "CPU time [ms]", .low = 0.0}};
  std::vector<Claim> rest;
  for (const GradientKind kind : kKinds) {
    const std::string name(gradient_name(kind));
    tell(context, name);
    const std::vector<Frame> frames = record(context, kind);
    std::string label = name;
    std::replace(label.begin(), label.end(), '_', ' ');
    plot::Series points{.label = label, .mark = plot::Mark::points};
    for (const Frame& f : frames) {
      add_row(outcome.tables[0],
              {name, f.time, f.pairs, f.contacts, f.query, f.texture, f.total()});
      points.x.push_back(f.contacts);
      points.y.push_back(1e3 * f.texture);
    }
    over.series.push_back(points);
    if (kind == kKinds[0]) {
      outcome.figure.panels = {draw_times(frames), draw_contacts(frames)};
      outcome.claims = {
          on_this_machine(at_least("linear",
                                   "mean CPU time of the textures in the frames with 0 to 7 "
                                   "contacts, by central differences as the text: R^2 of a line",
                                   growth_of(frames).of_means, 0.95))};
      rest = describe_contacts(frames);
    }
    const std::vector<Claim> more = describe(name, frames);
    rest.insert(rest.end(), more.begin(), more.end());
  }
  outcome.figure.panels.push_back(over);
  outcome.figure.title = "File on CAD part (Fig. 4.16)";
  outcome.claims.insert(outcome.claims.end(), rest.begin(), rest.end());
  return outcome;
}

}  // namespace thigma::experiments
