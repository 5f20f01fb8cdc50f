#pragma once
// What pairs of shapes need to make rows: the part of a world that only its steps look at.

#include <vector>

#include "thigma/constraint/build_constraints.h"
#include "thigma/core/index.h"
#include "thigma/multibody/world.h"

namespace thigma {

/// A kind of pair: two shapes, the first the one whose travel is measured, in the frame of the
/// second.
struct PairKind {
  std::int32_t first = -1, second = -1;  // shapes
  ConstraintWorld constraints;           // object: the first; its one scene body: the second
};

struct PairKinds {
  std::vector<PairKind> list;
};

/// By number. Thread: any.
inline const PairKind& pair_kind(const World& world, std::int32_t kind) noexcept {
  return world.pair_kinds->list[idx(kind)];
}

}  // namespace thigma
