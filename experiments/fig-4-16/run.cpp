// Fig. 4.16: what a frame with many textured contacts costs.

#include <algorithm>

#include "benchmarks/probe.h"
#include "experiments/common/all_experiments.h"
#include "experiments/common/statistics.h"
#include "scenes/textured_model.h"

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/texture/depth_gradient.h"

namespace thigma::experiments {
namespace fig_4_16 {
namespace {

/// Two blocks at random poses against each other.
struct Contacts {
  HapticTexture object, scene;
  std::vector<std::int32_t> object_triangles, scene_triangles;
  std::vector<DepthContact> all;
};

void make_contacts(Contacts& c, int count, int texels, std::uint64_t seed) {
  c.object = scenes::make_textured_model({"striped_block", texels});
  c.scene = c.object;
  for (std::int32_t t = 0; t < 4; ++t) {  // the top
    c.object_triangles.push_back(t);
    c.scene_triangles.push_back(t);
  }
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    DepthContact contact;
    const Quat over =
        Quat(0.0, 0.0, 1.0, 0.0) * rotation_from_vector(Vec3(0.0, 0.0, random.uniform(-0.3, 0.3)));
    contact.object = {&c.object, c.object_triangles,
                      Pose{Vec3(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), 0.020),
                           over.normalized()}};
    contact.scene = {&c.scene, c.scene_triangles, Pose{}};
    contact.point = Vec3(0.0, 0.0, 0.010);
    contact.normal = -Vec3::UnitZ();
    contact.centre = contact.object.world_from_body.position;
    c.all.push_back(contact);
  }
}

/// Least CPU time of a frame over some repeats [s].
double time_frame(std::span<const DepthContact> contacts, DepthBackend& backend, GradientKind kind,
                  GradientScratch& scratch, std::vector<DepthSamples>& samples, int repeats) {
  const double amplitude = 2.0 * contacts[0].object.texture->amplitude;
  double least = 1e9, sum = 0.0;
  for (int r = 0; r < repeats; ++r) {
    const double start = bench::thread_cpu();
    backend.sample(contacts, depth_request(kind, amplitude), samples);
    for (std::size_t i = 0; i < contacts.size(); ++i)
      sum += depth_gradient(contacts[i], samples[i], kind, scratch).linear.z();
    least = std::min(least, bench::thread_cpu() - start);
  }
  return sum == 1e300 ? sum : least;
}

}  // namespace
}  // namespace fig_4_16

Outcome run_fig_4_16(const Context& context) {
  using namespace fig_4_16;
  constexpr int kCounts[] = {1, 2, 5, 10, 20, 30, 40};
  constexpr GradientKind kKinds[] = {GradientKind::central_differences,
                                     GradientKind::smoothed_envelope, GradientKind::envelope};
  Contacts contacts;
  make_contacts(contacts, 40, context.quick ? 512 : 1024, context.seed);
  const auto backend = make_grid_depth({});
  GradientScratch scratch;
  std::vector<DepthSamples> samples(contacts.all.size());
  const int repeats = context.quick ? 5 : 30;
  Outcome outcome;
  outcome.tables = {
      {.name = "data", .columns = {"gradient", "contacts", "CPU time [s]", "rate [Hz]"}}};
  plot::Panel panel{.title = "A frame on a grid of 50 x 50",
                    .x = {.label = "contacts"},
                    .y = {.label = "CPU time [ms]"},
                    .guides = {{.label = "1 kHz", .value = 1.0}}};
  double worst = 1.0;
  for (const GradientKind kind : kKinds) {
    const std::string name(gradient_name(kind));
    plot::Series series{.label = name, .mark = plot::Mark::line_and_points};
    std::vector<double> counts, times;
    for (const int count : kCounts) {
      const std::span<const DepthContact> some(contacts.all.data(),
                                               static_cast<std::size_t>(count));
      time_frame(some, *backend, kind, scratch, samples, 1);
      counts.push_back(count);
      times.push_back(time_frame(some, *backend, kind, scratch, samples, repeats));
      add_row(outcome.tables[0], {name, counts.back(), times.back(), 1.0 / times.back()});
      series.x.push_back(counts.back());
      series.y.push_back(1e3 * times.back());
    }
    panel.series.push_back(series);
    const LineFit fit = fit_line(counts, times);
    worst = std::min(worst, fit.r_squared);
    outcome.claims.push_back(
        stated("per-contact-" + name, "CPU time of one more contact, " + name, fit.slope, "s"));
    outcome.claims.push_back(stated(
        "rate-" + name,
        "frames a second of CPU time with 20 contacts, " + name + "; the source's 100 to 200",
        1.0 / times[4], "Hz"));
  }
  outcome.figure = {.title = "Cost of textured contacts (Fig. 4.16)", .panels = {panel}};
  outcome.claims.insert(
      outcome.claims.begin(),
      on_this_machine(at_least("linear", "time against contacts: R^2 of a line, the least of the gradients",
                     worst, 0.95)));
  return outcome;
}

}  // namespace thigma::experiments
