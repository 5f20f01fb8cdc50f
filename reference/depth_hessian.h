#pragma once
// Second derivatives of the directional depth in six degrees of freedom.

#include "thigma/depth/depth_gradient.h"

namespace thigma {

/// How the gradient of a depth changes with the motion of the object.
struct DepthHessian {
  bool is_valid = false;
  // rows: linear, angular of DepthGradient; columns: a way, then a rotation vector about the centre
  // [world]. Not symmetric: `angular` is that of the turned object
  Mat6 gradient_by_motion = Mat6::Zero();
};

/// The same from both surfaces at the maximum, with the frame held.
///
/// contact   as given to the backend
/// sample    its result
/// scratch   working memory
/// returns   not valid where it is unbounded or not defined: where the maximum is no smooth one
///           within a texel (an edge, a crease, surfaces that follow each other), or the gradient
///           would turn by more than one over a texel
/// Thread    [contact]; no failure; allocates when a contact is larger than any before.
/// Source    Eq. 5.56 asks for it; envelope theorem of second order, docs/textures.md.
DepthHessian depth_hessian(const DepthContact& contact, const DepthSamples& sample,
                           GradientScratch& scratch) noexcept;

}  // namespace thigma
