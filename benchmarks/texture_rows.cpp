// Two plates with three random waves each, pressed together at random poses and slid by 10 um a
// frame: 40 contacts a frame in turn, warm.
#include "benchmarks/texture_rows.h"

#include <array>
#include <cstdio>
#include <memory>

#include "thigma/core/cpu_clock.h"
#include "thigma/depth/depth_gradient.h"
#include "thigma/depth/gpu_depth.h"
#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/models/textured_model.h"

namespace thigma::bench {
namespace {

constexpr double kSide = kPlateSide, kAmplitude = kPlateAmplitude;
constexpr int kMostContacts = 40;
constexpr double kSlide = 1e-5;  // a frame [m]

struct Contacts {
  HapticTexture object, scene;
  std::array<std::int32_t, 4> top = {0, 1, 2, 3};
  std::vector<DepthContact> all;
};

std::unique_ptr<Contacts> make_contacts(bool quick) {
  Random random(1);
  auto c = std::make_unique<Contacts>();
  c->object = wavy_plate(random, quick ? 128 : 1024);
  c->scene = wavy_plate(random, quick ? 128 : 1024);
  const Quat over(0.0, 1.0, 0.0, 0.0);  // turned over about x
  for (int i = 0; i < kMostContacts; ++i) {
    const auto tilt = [&] { return rotation_from_vector(0.02 * random.in_cube(1.0)); };
    const Quat turn = rotation_from_vector(Vec3(0.0, 0.0, random.uniform(-3.0, 3.0)));
    c->all.push_back(
        plate_contact({&c->object, c->top,
                       Pose{Vec3(0.3 * kSide * random.uniform(-1.0, 1.0),
                                 0.3 * kSide * random.uniform(-1.0, 1.0), 0.25 * kSide),
                            (tilt() * turn * over).normalized()}},
                      {&c->scene, c->top, Pose{}}));
  }
  return c;
}

struct Way {
  std::unique_ptr<DepthBackend> backend;
  GradientKind kind = GradientKind::envelope;
};

/// Gradients of every contact, contact by contact.
struct Timing {
  std::vector<double> seconds;      // of a contact
  double depth_sum = 0.0;           // of all [m]
  double found = 0.0, nodes = 0.0;  // mean a contact
};

Timing time_contacts(const Contacts& contacts, Way& way, int frames) {
  Timing timing;
  GradientScratch scratch;
  const DepthRequest request = depth_request(way.kind, 6.0 * kAmplitude, 0.1);
  const double share = 1.0 / (kMostContacts * frames);
  for (DepthContact contact : contacts.all) {
    for (int frame = -2; frame < frames; ++frame) {
      contact.object.world_from_body.position.x() += kSlide;
      DepthSamples sample;
      const double start = thread_cpu();
      way.backend->sample({&contact, 1}, request, {&sample, 1});
      const DepthGradient gradient = depth_gradient(contact, sample, way.kind, scratch);
      const double spent = thread_cpu() - start;
      if (frame < 0) continue;  // warming up
      timing.seconds.push_back(spent);
      timing.found += share * (sample.is_found && gradient.is_valid);
      timing.nodes += share * sample.nodes;
      if (sample.is_found) timing.depth_sum += share * sample.depth[0];
    }
  }
  return timing;
}

Row row_of(const std::string& name, const Timing& ours, const std::string& baseline,
           const Timing& theirs, const Timing& exact) {
  Row row;
  row.name = name;
  row.unit = "us";
  row.ours = figure_of(ours.seconds, 1e6);
  row.baseline = baseline;
  row.theirs = figure_of(theirs.seconds, 1e6);
  row.contacts_ours = ours.found;
  row.contacts_baseline = theirs.found;
  const auto missed = [&](const Timing& timing) {
    return std::to_string(100.0 * (exact.depth_sum - timing.depth_sum) / (6.0 * kAmplitude));
  };
  row.note = "per contact; depth lacks " + missed(ours) +
             " % of the amplitudes on average, the baseline " + missed(theirs) + " %";
  if (ours.nodes > 0.0)
    row.note += "; " + std::to_string(static_cast<int>(ours.nodes)) + " cells opened";
  return row;
}

double steady() { return clock_seconds(CLOCK_MONOTONIC); }

/// Times of frames with the first `count` contacts by a clock.
std::vector<double> time_frames(const Contacts& contacts, int count, DepthBackend& backend,
                                GradientKind kind, int frames, double (*clock)()) {
  std::vector<DepthContact> some(contacts.all.begin(), contacts.all.begin() + count);
  std::vector<DepthSamples> samples(some.size());
  std::vector<double> seconds;
  for (int frame = -2; frame < frames; ++frame) {
    for (DepthContact& contact : some) contact.object.world_from_body.position.x() += kSlide;
    const double start = clock();
    backend.sample(some, depth_request(kind, 6.0 * kAmplitude), samples);
    const double spent = clock() - start;
    if (frame >= 0) seconds.push_back(spent);
  }
  return seconds;
}

}  // namespace

DepthContact plate_contact(const TexturedPatch& object, const TexturedPatch& scene) {
  DepthContact contact;
  contact.object = object;
  contact.scene = scene;
  contact.point = Vec3(0.0, 0.0, 0.125 * kSide);
  contact.normal = -Vec3::UnitZ();
  contact.centre = object.world_from_body.position;
  return contact;
}

HapticTexture wavy_plate(Random& random, int texels, const Vec2& sideways) {
  std::array<Vec3, 3> waves;  // by x and y [1/m], phase [turns]
  for (Vec3& w : waves)
    w = Vec3(300.0 * random.uniform(-1.0, 1.0), 300.0 * random.uniform(-1.0, 1.0),
             random.uniform());
  const auto height = [&](double x, double y) {
    double sum = 0.0;
    for (const Vec3& w : waves)
      sum += kAmplitude * sine(2.0 * kPi * (w.x() * x + w.y() * y + w.z()));
    return sum;
  };
  TextureSource source =
      models::make_textured_slab({Vec3(kSide, kSide, 0.25 * kSide), texels, height});
  for (Texel& t : source.texels) {
    t.x = static_cast<float>(sideways.x()) * t.z;
    t.y = static_cast<float>(sideways.y()) * t.z;
  }
  return make_texture(std::move(source), "plate");
}

std::vector<Row> texture_rows(bool quick) {
  const auto contacts = make_contacts(quick);
  const int frames = quick ? 3 : 50;
  const auto grid = [&](SpanWidth width, GradientKind kind) {
    Way way{make_grid_depth({.width = width}), kind};
    return time_contacts(*contacts, way, frames);
  };
  Way branch{make_branch_depth({}), GradientKind::envelope};
  const Timing exact = time_contacts(*contacts, branch, frames);
  std::vector<Row> rows;
  Timing plain;  // scalar with the envelope
  for (const GradientKind kind : {GradientKind::envelope, GradientKind::smoothed_envelope,
                                  GradientKind::central_differences}) {
    const Timing scalar = grid(SpanWidth::scalar, kind), widest = grid(SpanWidth::widest, kind);
    if (kind == GradientKind::envelope) plain = scalar;
    rows.push_back(
        row_of("texture depth and gradient, 50 x 50, " + std::string(gradient_name(kind)), widest,
               "the same, scalar", scalar, exact));
  }
  rows.push_back(row_of("texture depth and gradient, all texels, warm", exact,
                        "50 x 50, envelope, scalar", plain, exact));
  return rows;
}

std::vector<Row> gpu_texture_rows(bool quick) {
  const GpuDepth gpu = make_gpu_depth({.timeout = 10.0, .warn = {}});
  if (!gpu.is_on_gpu) {
    std::fprintf(stderr, "left out, no graphics processor: %s\n", gpu.reason.c_str());
    return {};
  }
  const auto contacts = make_contacts(quick);
  const auto scalar = make_grid_depth({.width = SpanWidth::scalar});
  const int frames = quick ? 2 : 30;
  std::vector<Row> rows;
  for (const GradientKind kind : {GradientKind::envelope, GradientKind::central_differences}) {
    for (const int count : {1, 5, 10, 20, kMostContacts}) {
      Row row;
      row.name = "texture depths on the GPU, " + std::string(gradient_name(kind)) + ", " +
                 std::to_string(count) + " contacts";
      row.unit = "us";
      double (*const clock)() = gpu.is_software ? process_cpu_seconds : steady;
      row.ours = figure_of(time_frames(*contacts, count, *gpu.backend, kind, frames, clock), 1e6);
      row.baseline = "scalar, one core";
      row.theirs = figure_of(time_frames(*contacts, count, *scalar, kind, frames, thread_cpu), 1e6);
      row.contacts_ours = row.contacts_baseline = count;
      row.note = gpu.renderer + (gpu.is_software ? ", software: CPU time of all its threads"
                                                 : ": time from the call to the result");
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace thigma::bench
