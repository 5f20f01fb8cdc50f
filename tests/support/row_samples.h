#pragma once
// Samples of a session under constraints.

#include "thigma/loop/samples.h"

namespace thigma::test {

inline HapticSample grasped(std::uint64_t frame) {
  HapticSample s;
  s.frame = frame;
  s.time = 1e-3 * static_cast<double>(frame);
  s.elapsed = 1e-3;
  s.is_grasped = true;
  return s;
}

inline ContactSample with_rows(std::size_t count) {
  ContactSample c;
  for (std::size_t i = 0; i < count; ++i)
    c.model.constraints.rows.push_back(make_row(RowKind::scene_plane));
  c.rows = static_cast<std::int64_t>(count);
  return c;
}

}  // namespace thigma::test
