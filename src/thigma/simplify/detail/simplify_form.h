#pragma once
// What the loop of simplification does beside the atomic operation, step by step.

#include <array>
#include <vector>

#include "thigma/convex/decomposition.h"
#include "thigma/mesh/halfedge_mesh.h"
#include "thigma/simplify/simplify_params.h"

namespace thigma {

struct Simplification;

namespace detail {

/// Steps that can be left out, to see what each brings. Simplification takes all.
struct SimplifyForm {
  bool is_relaxed = true;          // step 3
  bool keeps_volume = true;        // the relaxed position first tried keeps the object's volume
  bool seeks_convex_start = true;  // where neither quadric nor ends will do, the best convex one
  bool flips_edges = true;         // reflex edges flip where no more can collapse
};

/// simplify_surface in any form.
Simplification simplify_in_form(const DecomposedSurface& decomposed, const SimplifyParams& params,
                                const SimplifyForm& form,
                                std::vector<std::array<double, 2>> support = {},
                                CornerAttributes attributes = {});

}  // namespace detail
}  // namespace thigma
