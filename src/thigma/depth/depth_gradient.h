#pragma once
// The gradient of directional depth by the six degrees of freedom of the object.

#include <string_view>

#include "thigma/depth/depth.h"
#include "thigma/depth/gradient_kind.h"

namespace thigma {

/// d depth / d(position, rotation vector) of the object; the rotation is about the contact's
/// `centre`.
struct DepthGradient {
  bool is_valid = false;        // false: no depth, or a moved configuration without one
  Vec3 linear = Vec3::Zero();   // [-; world]; 1 along n
  Vec3 angular = Vec3::Zero();  // [m/rad; world]
};

/// The kind of a name ("central_differences", ..), or false.
/// Thread    [offline].
bool gradient_kind(std::string_view name, GradientKind& kind) noexcept;
std::string_view gradient_name(GradientKind kind) noexcept;

/// What to ask of a backend for a kind of gradient.
///
/// amplitude  of the contact's textures together [m]
/// smoothing  smoothed_envelope: share of the amplitude within which a depth is near the maximum
DepthRequest depth_request(GradientKind kind, double amplitude, double smoothing = 0.1) noexcept;

/// Memory of one gradient at a time. Any content is valid; grows to the largest contact.
struct GradientScratch {
  ProjectedPatch object, scene;
};

/// Gradient from what a backend found.
///
/// contact   as given to the backend
/// sample    its result, computed with depth_request(kind, ..)
/// scratch   working memory
/// returns   d depth/dn = 1 by definition (Eq. 4.6); not valid where the samples are not
/// Thread    [contact]; no failure; allocates when a contact is larger than any before.
/// Source    Eqs. 4.6, 4.8; for the envelope theorem docs/textures.md.
DepthGradient depth_gradient(const DepthContact& contact, const DepthSamples& sample,
                             GradientKind kind, GradientScratch& scratch) noexcept;

/// Gradient at one place, from both surfaces there.
///
/// object, scene  jets at the same point of the plane
/// frame          of the contact
/// centre         what the object turns about [m; world]
/// slope          d height/d(u, v) that both surfaces have at the maximum (envelope_slope) [-]
/// Source    derivative of Eq. 4.9 at a fixed point of the plane.
DepthGradient gradient_at(const SurfaceJet& object, const ContactFrame& frame, const Vec3& centre,
                          const Vec2& slope) noexcept;

/// A smooth maximum of the depth within a texel of a point. texel: no step is longer [m]
struct SmoothPeak {
  bool is_near = false;
  Vec2 step = Vec2::Zero();  // from the point to it: a Newton step from second derivatives [m]
  Mat2 bowl = Mat2::Zero();  // minus the second derivatives of the depth along the plane [1/m]
};
SmoothPeak smooth_peak(const SurfaceJet& object, const SurfaceJet& scene, double texel) noexcept;

/// The object's jet with its point a step away along the plane, to first order; all else as it is.
SurfaceJet carried(const SurfaceJet& jet, const Vec2& step) noexcept;

/// The slope along n that both surfaces share at the maximum next to a point: where the slopes at
/// the point differ, a Newton step from second derivatives says what they are at the maximum
/// itself; at an edge of one side's domain it is the other side's.
///
/// peak   of the two (smooth_peak)
/// edge   -1: the object ends there, 1: the scene does, 0: neither
Vec2 envelope_slope(const SurfaceJet& object, const SurfaceJet& scene, const SmoothPeak& peak,
                    int edge) noexcept;

}  // namespace thigma
