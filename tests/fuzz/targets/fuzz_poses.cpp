#include <cmath>

#include "fuzz/fuzz_target.h"
#include "pose_file.h"

namespace thigma::fuzz {

void fuzz_poses(Bytes bytes) {
  std::vector<Pose> poses;
  if (!is_taken("poses", [&] { poses = app::parse_poses(text_of(bytes), "poses"); })) return;
  require(!poses.empty(), "there is a pose");
  for (const Pose& p : poses) {
    require(p.position.allFinite(), "positions are finite");
    require(std::abs(p.orientation.norm() - 1.0) < 1e-9, "quaternions are unit");
  }
}

}  // namespace thigma::fuzz
