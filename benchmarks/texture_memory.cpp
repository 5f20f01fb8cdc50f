// Textured contacts whose textures come from memory, and the same from the caches.
#include <array>
#include <memory>

#include "benchmarks/texture_rows.h"

#include "thigma/core/cpu_clock.h"
#include "thigma/depth/depth_gradient.h"
#include "thigma/math/rotation.h"

namespace thigma::bench {
namespace {

constexpr int kTextures = 16, kContacts = 40;
constexpr double kSlide = 1e-5;  // a frame [m]

struct Turns {
  std::vector<HapticTexture> textures;
  std::array<std::int32_t, 4> top = {0, 1, 2, 3};
  std::vector<DepthContact> contacts;
};

std::unique_ptr<Turns> make_turns(int texels, const Vec2& sideways) {
  Random random(1);
  auto turns = std::make_unique<Turns>();
  for (int i = 0; i < kTextures; ++i)
    turns->textures.push_back(wavy_plate(random, texels, sideways));
  const Quat over(0.0, 1.0, 0.0, 0.0);  // turned over about x
  for (std::size_t i = 0; i < kContacts; ++i) {
    const Quat tilt = rotation_from_vector(0.02 * random.in_cube(1.0)),
               turn = rotation_from_vector(Vec3(0.0, 0.0, random.uniform(-3.0, 3.0)));
    const double x = random.uniform(-0.3, 0.3), y = random.uniform(-0.3, 0.3);
    turns->contacts.push_back(
        plate_contact({&turns->textures[2 * i % kTextures], turns->top,
                       Pose{kPlateSide * Vec3(x, y, 0.25), (tilt * turn * over).normalized()}},
                      {&turns->textures[(2 * i + 1) % kTextures], turns->top, Pose{}}));
  }
  return turns;
}

/// Slides a contact a step and computes its depth and gradient.
class Slider {
 public:
  explicit Slider(bool has_quads) : backend_(make_grid_depth({.has_quads = has_quads})) {}
  /// CPU time [s]
  double step(DepthContact& contact) {
    contact.object.world_from_body.position.x() += kSlide;
    const double start = thread_cpu();
    backend_->sample({&contact, 1}, request_, {&sample_, 1});
    found_ += depth_gradient(contact, sample_, GradientKind::envelope, scratch_).is_valid;
    ++steps_;
    return thread_cpu() - start;
  }
  double found() const { return static_cast<double>(found_) / steps_; }

 private:
  std::unique_ptr<DepthBackend> backend_;
  DepthRequest request_ = depth_request(GradientKind::envelope, 6.0 * kPlateAmplitude);
  DepthSamples sample_;
  GradientScratch scratch_;
  int found_ = 0, steps_ = 0;
};

/// All contacts in turn: each finds its textures out of the caches.
std::vector<double> in_turn(std::vector<DepthContact> contacts, int frames, Slider& slider) {
  std::vector<double> seconds;
  for (int frame = -1; frame < frames; ++frame) {
    for (DepthContact& contact : contacts) {
      const double spent = slider.step(contact);
      if (frame >= 0) seconds.push_back(spent);
    }
  }
  return seconds;
}

/// Each again and again.
std::vector<double> one_by_one(std::vector<DepthContact> contacts, int frames, Slider& slider) {
  std::vector<double> seconds;
  for (DepthContact& contact : contacts) {
    for (int frame = -2; frame < frames; ++frame) {
      const double spent = slider.step(contact);
      if (frame >= 0) seconds.push_back(spent);
    }
  }
  return seconds;
}

}  // namespace

std::vector<Row> texture_memory_rows(bool quick) {
  const int texels = quick ? 128 : 1024, frames = quick ? 2 : 30;
  std::vector<Row> rows;
  for (const bool is_sideways : {false, true}) {
    const auto turns = make_turns(texels, is_sideways ? Vec2(0.3, -0.2) : Vec2::Zero());
    for (const bool is_cold : {true, false}) {
      const auto time = is_cold ? in_turn : one_by_one;
      Slider quads(true), displacements(false);
      Row row;
      row.name = std::string("textured contact, 50 x 50, envelope, ") +
                 (is_sideways ? "displaced sideways too, " : "heights along the normal, ") +
                 (is_cold ? "cold" : "hot");
      row.unit = "us";
      row.ours = figure_of(time(turns->contacts, frames, quads), 1e6);
      row.baseline = "maps of displacements";
      row.theirs = figure_of(time(turns->contacts, frames, displacements), 1e6);
      row.contacts_ours = quads.found();
      row.contacts_baseline = displacements.found();
      row.note = std::to_string(texels) + " x " + std::to_string(texels) + " texels; " +
                 (is_cold ? "40 contacts of 16 textures in turn" : "one contact after the other");
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace thigma::bench
