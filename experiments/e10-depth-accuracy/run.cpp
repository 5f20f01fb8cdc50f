// Protocol E10 (docs/sources.md): directional depth, its gradient and its Hessian against closed
// forms, and against rays through displaced meshes.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "experiments/common/statistics.h"
#include "experiments/common/texture_experiments.h"
#include "experiments/e10-depth-accuracy/fine_meshes.h"
#include "reference/depth_hessian.h"

#include "thigma/depth/depth_gradient.h"
#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/models/textured_model.h"

namespace thigma::experiments {
namespace e10_depth_accuracy {
namespace {

// of a plate, amplitudes of its waves [m]
constexpr double kSide = 0.02, kUpper = 2e-4, kLower = 3e-4;

// One wave along x and one along y, of the same length on both plates. With the upper one shifted
// by x the largest sum of a cos(k (s - x)) and b cos(k s) over s is sqrt(a^2 + b^2 + 2 a b cos(k
// x)): depth, slope and curvature in closed form.
struct ClosedForm {
  double depth = 0.0;
  Vec2 gradient = Vec2::Zero(), hessian = Vec2::Zero();  // by x and y: the mixed derivative is 0
};

ClosedForm closed_form(double k, const Vec2& shift) {
  ClosedForm f;
  for (int i = 0; i < 2; ++i) {
    const SinCos at = sin_cos(k * shift[i]);
    const double ab = kUpper * kLower;
    const double root = std::sqrt(kUpper * kUpper + kLower * kLower + 2.0 * ab * at.cos);
    f.depth += root;
    f.gradient[i] = -ab * k * at.sin / root;
    f.hessian[i] = -ab * k * k * at.cos / root - f.gradient[i] * f.gradient[i] / root;
  }
  return f;
}

/// A plate with a height over its top, and the top as triangles.
struct Plate {
  std::function<double(double, double)> height;
  HapticTexture texture;
};

Plate make_plate(int texels, std::function<double(double, double)> height) {
  Plate plate;
  plate.texture = make_texture(
      models::make_textured_slab({Vec3(kSide, kSide, 0.25 * kSide), texels, height}), "plate");
  plate.height = std::move(height);
  return plate;
}

Plate wave_plate(int texels, double k, double amplitude) {
  return make_plate(
      texels, [=](double x, double y) { return amplitude * (cosine(k * x) + cosine(k * y)); });
}

constexpr std::array<std::int32_t, 4> kTop = {0, 1, 2, 3};

/// The upper plate turned over about x lies on the lower one, shifted within the plane.
DepthContact contact_of(const Plate& object, const Plate& scene, const Pose& placed) {
  DepthContact contact;
  contact.object = {&object.texture, kTop, placed};
  contact.scene = {&scene.texture, kTop, Pose{}};
  contact.point = Vec3(0.0, 0.0, 0.125 * kSide);
  contact.normal = -Vec3::UnitZ();
  contact.centre = placed.position;
  return contact;
}

Pose turned_over(const Vec2& shift) {
  return {Vec3(shift.x(), shift.y(), 0.25 * kSide), Quat(0.0, 1.0, 0.0, 0.0)};
}

struct Errors {
  // relative to the amplitude, the steepest slope, the sharpest curvature
  std::vector<double> depth, gradient, hessian;
};

struct Method {
  const char* name;
  GradientKind gradient;
  bool is_polished;
};
constexpr Method kMethods[] = {{"samples, differences", GradientKind::central_differences, false},
                               {"samples, envelope", GradientKind::envelope, false},
                               {"climbed, envelope", GradientKind::envelope, true}};

Errors measure(const Method& method, const Plate& upper, const Plate& lower, double k,
               int resolution, int shifts, std::uint64_t seed) {
  const auto backend =
      make_grid_depth({.resolution = resolution, .is_polished = method.is_polished});
  GradientScratch scratch;
  Random random(seed);
  Errors errors;
  const double steepest = k * std::min(kUpper, kLower);
  for (int i = 0; i < shifts; ++i) {
    // Up to a third of a wave: beyond half a wave the maximum is another one.
    const double reach = kPi / (1.5 * k);
    const Vec2 shift(reach * random.uniform(-1.0, 1.0), reach * random.uniform(-1.0, 1.0));
    DepthContact contact = contact_of(upper, lower, turned_over(shift));
    contact.reach = 1.5 * kPi / k;  // one wave: where waves repeat, the maximum would too
    DepthSamples sample;
    backend->sample({&contact, 1}, depth_request(method.gradient, kUpper + kLower), {&sample, 1});
    const DepthGradient gradient = depth_gradient(contact, sample, method.gradient, scratch);
    if (!sample.is_found || !gradient.is_valid) continue;
    const ClosedForm want = closed_form(k, shift);
    errors.depth.push_back(std::fabs(sample.depth[0] - want.depth) / (kUpper + kLower));
    errors.gradient.push_back((gradient.linear.head<2>() - want.gradient).norm() / steepest);
    if (method.gradient == GradientKind::central_differences) continue;
    const DepthHessian hessian = depth_hessian(contact, sample, scratch);
    // A sample may be farther than a texel from the maximum; what was climbed to may not.
    if (!hessian.is_valid && !method.is_polished) continue;
    const Mat2 off =
        hessian.gradient_by_motion.topLeftCorner<2, 2>() - Mat2(want.hessian.asDiagonal());
    errors.hessian.push_back(hessian.is_valid ? off.norm() / (k * steepest)
                                              : std::numeric_limits<double>::infinity());
  }
  return errors;
}

/// The top of a plate as a displaced mesh, projected along z of the contact, with buckets to find
/// the triangle over a place.
class DisplacedMesh {
 public:
  DisplacedMesh(const Plate& plate, const Pose& placed, int cells, double sign)
      : cells_(cells), sign_(sign) {
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        const double x = kSide * (static_cast<double>(i) / cells - 0.5),
                     y = kSide * (static_cast<double>(j) / cells - 0.5);
        const Vec3 p =
            placed.position + placed.orientation * Vec3(x, y, 0.125 * kSide + plate.height(x, y));
        points_.push_back(p);
      }
    }
    buckets_.resize(static_cast<std::size_t>(kBuckets * kBuckets));
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
        for (int half = 0; half < 2; ++half) add(j * (cells + 1) + i, half);
  }
  const std::vector<Vec3>& points() const { return points_; }

  /// Height along `sign` over a place, NaN outside.
  double height(const Vec2& at) const {
    double best = std::nan("");
    const int b = bucket(at.x()), c = bucket(at.y());
    for (const std::array<int, 3>& t : buckets_[static_cast<std::size_t>(c * kBuckets + b)]) {
      const Vec3 &p = point(t[0]), &q = point(t[1]), &r = point(t[2]);
      Mat2 edges;
      edges << (q - p).head<2>(), (r - p).head<2>();
      const Vec2 w = edges.inverse() * (at - p.head<2>());
      if (w.minCoeff() < -1e-9 || w.sum() > 1.0 + 1e-9) continue;
      const double z = sign_ * (p.z() + w.x() * (q.z() - p.z()) + w.y() * (r.z() - p.z()));
      if (!(best >= z)) best = z;
    }
    return best;
  }

 private:
  static constexpr int kBuckets = 96;
  static constexpr double kExtent = 2.0 * kSide;  // of all buckets about the origin [m]
  const Vec3& point(int i) const { return points_[static_cast<std::size_t>(i)]; }
  static int bucket(double x) {
    return std::clamp(static_cast<int>((x / kExtent + 0.5) * kBuckets), 0, kBuckets - 1);
  }
  void add(int a, int half) {
    const int n = cells_ + 1;
    const std::array<int, 3> t = half == 0 ? std::array<int, 3>{a, a + 1, a + n + 1}
                                           : std::array<int, 3>{a, a + n + 1, a + n};
    Vec2 low = point(t[0]).head<2>(), high = low;
    for (const int i : t) {
      low = low.cwiseMin(point(i).head<2>());
      high = high.cwiseMax(point(i).head<2>());
    }
    for (int c = bucket(low.y()); c <= bucket(high.y()); ++c)
      for (int b = bucket(low.x()); b <= bucket(high.x()); ++b)
        buckets_[static_cast<std::size_t>(c * kBuckets + b)].push_back(t);
  }
  int cells_;
  double sign_;
  std::vector<Vec3> points_;
  std::vector<std::vector<std::array<int, 3>>> buckets_;
};

/// Depth along z by rays through every vertex of either mesh.
double ray_depth(const DisplacedMesh& upper, const DisplacedMesh& lower) {
  double best = kNoDepth;
  const auto cast = [&](const DisplacedMesh& from, const DisplacedMesh& to, double sign) {
    for (const Vec3& p : from.points()) {
      const double other = to.height(p.head<2>());
      if (std::isfinite(other)) best = std::max(best, sign * p.z() + other);
    }
  };
  cast(upper, lower, -1.0);
  cast(lower, upper, 1.0);
  return best;
}

/// Plates of random waves at random turns, the upper one tilted by up to `tilt`: errors by the
/// amplitudes, of all texels and of the polished grid.
std::array<std::vector<double>, 2> against_rays(const Context& context, double tilt, int pairs,
                                                int cells) {
  Random random(context.seed + 7);
  std::array<std::vector<double>, 2> errors;
  const auto exact = make_branch_depth({}), grid = make_grid_depth({});
  const auto rough = [&] {
    std::array<Vec3, 3> waves;
    for (Vec3& w : waves)
      w = Vec3(250.0 * random.uniform(-1.0, 1.0), 250.0 * random.uniform(-1.0, 1.0),
               random.uniform());
    return make_plate(context.quick ? 256 : 512, [waves](double x, double y) {
      double sum = 0.0;
      for (const Vec3& w : waves) sum += 1e-4 * sine(2.0 * kPi * (w.x() * x + w.y() * y + w.z()));
      return sum;
    });
  };
  for (int i = 0; i < pairs; ++i) {
    const Plate upper = rough(), lower = rough();
    const Quat turn = rotation_from_vector(Vec3(0.0, 0.0, random.uniform(-3.0, 3.0))),
               lean = rotation_from_vector(
                   Vec3(tilt * random.uniform(-1.0, 1.0), tilt * random.uniform(-1.0, 1.0), 0.0));
    Pose placed =
        turned_over(Vec2(0.002 * random.uniform(-1.0, 1.0), 0.002 * random.uniform(-1.0, 1.0)));
    placed.orientation = lean * turn * placed.orientation;
    const DepthContact contact = contact_of(upper, lower, placed);
    const double want = ray_depth(DisplacedMesh(upper, placed, cells, -1.0),
                                  DisplacedMesh(lower, Pose{}, cells, 1.0));
    for (std::size_t k = 0; k < 2; ++k) {
      DepthSamples sample;
      (k == 0 ? *exact : *grid).sample({&contact, 1}, {}, {&sample, 1});
      const double amplitude = upper.texture.amplitude + lower.texture.amplitude;
      if (sample.is_found) errors[k].push_back(std::fabs(sample.depth[0] - want) / amplitude);
    }
  }
  return errors;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? std::nan("") : *std::max_element(values.begin(), values.end());
}

}  // namespace
}  // namespace e10_depth_accuracy

Outcome run_e10_depth_accuracy(const Context& context) {
  using namespace e10_depth_accuracy;
  constexpr int kResolutions[] = {25, 50, 100, 200};
  Outcome outcome;
  outcome.tables = {
      {.name = "data",
       .columns = {"method", "resolution", "depth error", "gradient error", "Hessian error"}},
      {.name = "aliasing",
       .columns = {"cells a wave", "depth error, samples", "depth error, climbed"}}};
  plot::Panel depths{.title = "Depth",
                     .x = {.label = "samples a side", .is_log = true},
                     .y = {.label = "RMS error / amplitude", .is_log = true}};
  plot::Panel slopes{.title = "Gradient",
                     .x = {.label = "samples a side", .is_log = true},
                     .y = {.label = "RMS error / steepest slope", .is_log = true}};
  const int texels = context.quick ? 512 : 1024, shifts = context.quick ? 20 : 100;
  const double k = 2.0 * kPi / 0.008;
  const Plate upper = wave_plate(texels, k, kUpper), lower = wave_plate(texels, k, kLower);
  std::array<double, 3> depth_order{}, slope_order{}, hessian_at_most{};
  for (std::size_t m = 0; m < 3; ++m) {
    tell(context, kMethods[m].name);
    std::vector<double> spacing, depth, slope;
    for (const int resolution : kResolutions) {
      const Errors e = measure(kMethods[m], upper, lower, k, resolution, shifts, context.seed);
      spacing.push_back(1.0 / resolution);
      depth.push_back(root_mean_square(e.depth));
      slope.push_back(root_mean_square(e.gradient));
      const double bend = e.hessian.empty() ? std::nan("") : root_mean_square(e.hessian);
      hessian_at_most[m] = bend;
      add_row(outcome.tables[0], {std::string(kMethods[m].name), static_cast<double>(resolution),
                                  depth.back(), slope.back(), bend});
    }
    std::vector<double> sides(std::begin(kResolutions), std::end(kResolutions));
    depths.series.push_back(
        {.label = kMethods[m].name, .x = sides, .y = depth, .mark = plot::Mark::line_and_points});
    slopes.series.push_back(
        {.label = kMethods[m].name, .x = sides, .y = slope, .mark = plot::Mark::line_and_points});
    depth_order[m] = fit_power(spacing, depth).slope;
    slope_order[m] = fit_power(spacing, slope).slope;
    if (m == 2) {
      outcome.claims.push_back(at_most(
          "depth", "depth climbed to from 50 x 50: RMS error by the amplitude", depth[1], 1e-3));
      outcome.claims.push_back(at_most(
          "gradient", "envelope gradient there: RMS error by the steepest slope", slope[1], 0.01));
      outcome.claims.push_back(
          at_most("hessian", "Hessian from both curvatures there: RMS error by the sharpest",
                  hessian_at_most[m], 0.05));
    }
  }
  outcome.claims.push_back(within(
      "order-depth",
      "order of the depth error in the spacing of samples, not climbed; 2 for a smooth maximum",
      depth_order[1], 1.5, 2.5));
  outcome.claims.push_back(at_least(
      "order-gradient", "order of the gradient error in that spacing, envelope, not climbed",
      slope_order[1], 1.0));
  outcome.claims.push_back(stated("order-differences",
                                  "order of the gradient error, central differences over a cell",
                                  slope_order[0]));

  tell(context, "aliasing");
  double worst_at_four = 0.0;
  for (const double cells : {16.0, 8.0, 4.0, 3.0, 2.0}) {
    // The reach of a contact is 1.5 waves; 50 cells across it.
    const double short_wave = cells * kSide / 50.0, short_k = 2.0 * kPi / short_wave;
    const Plate a = wave_plate(texels, short_k, kUpper), b = wave_plate(texels, short_k, kLower);
    Random random(context.seed + 3);
    std::array<std::vector<double>, 2> off;
    for (int i = 0; i < shifts; ++i) {
      const Vec2 shift(0.3 * short_wave * random.uniform(-1.0, 1.0),
                       0.3 * short_wave * random.uniform(-1.0, 1.0));
      const DepthContact contact = contact_of(a, b, turned_over(shift));
      for (std::size_t p = 0; p < 2; ++p) {
        DepthSamples sample;
        make_grid_depth({.is_polished = p == 1})->sample({&contact, 1}, {}, {&sample, 1});
        off[p].push_back(std::fabs(sample.depth[0] - closed_form(short_k, shift).depth) /
                         (kUpper + kLower));
      }
    }
    add_row(outcome.tables[1], {cells, root_mean_square(off[0]), root_mean_square(off[1])});
    if (cells == 4.0) worst_at_four = root_mean_square(off[1]);
  }
  outcome.claims.push_back(
      at_most("aliasing", "depth climbed to with four samples a wave: RMS error by the amplitude",
              worst_at_four, 0.02));

  tell(context, "rays");
  const int pairs = context.quick ? 6 : 30, cells = context.quick ? 200 : 400;
  const auto level = against_rays(context, 0.0, pairs, cells),
             leaning = against_rays(context, 0.02, pairs, cells);
  outcome.claims.push_back(at_most("rays",
                                   "depth over all texels against rays through displaced meshes: "
                                   "largest error by the amplitudes",
                                   largest(level[0]), 0.02));
  outcome.claims.push_back(
      stated("rays-grid", "the same, climbed to from 50 x 50", largest(level[1])));
  outcome.claims.push_back(stated("rays-leaning",
                                  "over all texels, plates leaning by up to 1.1 degrees each way",
                                  largest(leaning[0])));
  against_fine_meshes(context, outcome);
  outcome.figure = {.title = "Accuracy of directional depth (E10)", .panels = {depths, slopes}};
  return outcome;
}

}  // namespace thigma::experiments
