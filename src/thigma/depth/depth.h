#pragma once
// Directional penetration depth of textured patches: one interface, several ways to compute it.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "thigma/core/static_vector.h"
#include "thigma/depth/height_map.h"
#include "thigma/depth/projected_patch.h"

namespace thigma {

/// A contact to refine, as collision detection between the coarse surfaces found it.
struct DepthContact {
  TexturedPatch object, scene;
  Vec3 point = Vec3::Zero();    // about where [m; world]
  Vec3 normal = Vec3::UnitZ();  // n: unit, out of the object, into the scene [world]
  Vec3 centre = Vec3::Zero();   // what the object turns about: its centre of mass [m; world]
  // half the side of the square about `point`, along u and v, beyond which nothing counts [m]
  double reach = std::numeric_limits<double>::infinity();
};

/// The motions of the object at which central differences need the depth (Eq. 4.8): one of
/// `configuration_motion`.
inline constexpr int kConfigurations = 11;

/// What to compute beside the depth.
struct DepthRequest {
  bool has_differences = false;  // also at the ten moved configurations
  // shift along u and v [m]; turns are by step / |point - centre|. 0: the method's own
  double step = 0.0;
  double near = 0.0;  // also where the depth is within this of its maximum [m]; 0: only the maximum
};

/// A place whose depth is almost the largest, and how much it counts.
struct NearMaximum {
  Vec2 at = Vec2::Zero();  // [m; contact plane]
  double weight = 0.0;     // (depth there - (largest - near))^2, up to a factor [m^2]
};
inline constexpr std::size_t kMaxNear = 64;

inline constexpr double kNoDepth = -std::numeric_limits<double>::infinity();

/// Directional depth of one contact: the maximum over the common domain of the height of the
/// object's surface above the scene's along n; positive where they penetrate.
struct DepthSamples {
  // the patches have a common domain and the input is finite; otherwise nothing below
  bool is_found = false;
  bool is_height_field =
      // false: at the deepest place some patch is none along n; the depth is that of its outermost
      // sheet
      true;
  // true: is_height_field is false, and the depth is that of the displaced texels themselves, the
  // outermost of all sheets near the place, those of triangles that are seen edge-on among them
  bool is_of_sheets = false;
  ContactFrame frame;  // about the contact's point
  // as it is, then moved; kNoDepth where moved apart, or not asked for [m]
  std::array<double, kConfigurations> depth;
  double shift = 0.0;      // of the moved configurations [m]
  double turn = 0.0;       // [rad]
  Vec2 at = Vec2::Zero();  // where depth[0] is [m; contact plane]
  // over all texels depth[0] + remaining is not exceeded [m]; infinite: not known
  double remaining = std::numeric_limits<double>::infinity();
  std::int32_t nodes = 0;                    // of the search that gave depth[0]
  StaticVector<NearMaximum, kMaxNear> near;  // with at least the maximum itself
  DepthSamples() noexcept { depth.fill(kNoDepth); }
};

/// Motion of the object that makes configuration i of a sample from where it is: 0 none, then to
/// and fro (+, -) along u, v, about u, v, n through the centre.
Pose configuration_motion(const DepthSamples& sample, const Vec3& centre, int i) noexcept;

/// Computes depths, all contacts of a frame in one call.
///
/// Thread: one thread at a time. Holds scratch memory (a GPU its own), so there is one object a
/// thread.
class DepthBackend {
 public:
  DepthBackend() = default;
  DepthBackend(const DepthBackend&) = delete;
  DepthBackend& operator=(const DepthBackend&) = delete;
  virtual ~DepthBackend() = default;

  /// Depth of every contact.
  ///
  /// contacts  normals of unit length to 1e-9; textures alive and unchanged
  /// results   one a contact, overwritten
  /// Thread    [contact]; no failure; allocates when a contact is larger than any before, never
  ///           later.
  /// Source    Eqs. 4.3, 4.9, 4.10; with differences 4.8 and Sec. 4.4.2.
  virtual void sample(std::span<const DepthContact> contacts, const DepthRequest& request,
                      std::span<DepthSamples> results) noexcept = 0;
};

/// Depth on a grid of samples, as the text has it.
struct GridDepthParams {
  int resolution = 50;                  // samples along each axis of the common domain, 2..4096
  SpanWidth width = SpanWidth::widest;  // scalar is the reference; all give the same bits
  bool has_quads = true;    // maps are of heights in 16 bits; false: of displacements, which takes
                            // longer and changes depths that are not polished by a 65,536th
  bool is_polished = true;  // climb from the best sample to the maximum near it, below texel size
};

/// How its maps are read.
inline MapReading reading_of(const GridDepthParams& params) noexcept {
  return {params.width, params.has_quads};
}

/// At configurations moved within the plane the object's map is read shifted or turned instead of
/// rendered anew: 6 maps instead of 11. The default step is one cell of the grid.
/// Thread    [offline]; the result as DepthBackend.
std::unique_ptr<DepthBackend> make_grid_depth(const GridDepthParams& params);

/// Depth over every texel of both sides, by branch and bound over the pyramids.
struct BranchDepthParams {
  int max_nodes =
      // of one search; beyond, it ends with the first depth it has, and `remaining` says what may
      // have been missed
      100000;
};

/// The exact maximum over all texel centres of either side that lie over the other, heights between
/// texels interpolated. The default step is one texel of the finer side. A search starts from the
/// best texel of the contact's last search as long as the contacts keep their order; results do not
/// depend on that, but which of equal maxima is named may.
/// Thread    [offline]; the result as DepthBackend.
std::unique_ptr<DepthBackend> make_branch_depth(const BranchDepthParams& params);

}  // namespace thigma
