#pragma once
// Rules of the text in one piece; the contact query applies them in parts.

namespace thigma {

/// Refine a pair whose weighted deviation s* exceeds the threshold s0, strictly. The contact query
/// decides by their ratio, together with the cap and the blend.
/// Source    Sec. 3.4.3.
inline bool needs_refinement(double weighted, double threshold) noexcept {
  return weighted > threshold;
}

/// d_ab: distance within which two nodes must be kept for contacts within `tolerance` of their
/// surfaces [m].
/// Source    Eq. 3.5.
inline double pair_tolerance(double tolerance, double hausdorff_object,
                             double hausdorff_scene) noexcept {
  return tolerance + hausdorff_object + hausdorff_scene;
}

}  // namespace thigma
