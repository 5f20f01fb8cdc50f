#pragma once
// Paths as CSV: one pose a row.

#include <string>
#include <string_view>
#include <vector>

#include "thigma/math/pose.h"

namespace thigma::app {

/// Reads poses: first line `x,y,z,qx,qy,qz,qw`, then seven finite numbers a line [m]; quaternions
/// are unit to 1e-6 and returned normalized. Empty lines are skipped.
/// Thread [offline]; throws InputError naming the line.
std::vector<Pose> read_poses(const std::string& path);

/// The same of text; name: of the file, for messages.
std::vector<Pose> parse_poses(std::string_view text, const std::string& name);

}  // namespace thigma::app
