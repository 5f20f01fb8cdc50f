#include "experiments/level-choice/casts.h"

#include <cstdlib>
#include <filesystem>

#include "thigma/scene/scene_file.h"

namespace thigma::experiments::level_choice {
namespace {

/// Scale: 0.24 mm a unit. Near contact: turned by -4 degrees about x through (0, 18.55, 97.07)
/// units, then moved by (12.04, 24.09, 27.87) units.
constexpr const char* kScene = R"(title = "casts"
[object]
mesh = "a02_dental_cast_lower.obj"
unit_scale = 0.00024
position = [0.0028896, 0.004167342, 0.007056106]
quat_xyzw = [-0.0348994967025010, 0.0, 0.0, 0.9993908270190958]
[[static]]
mesh = "a01_dental_cast_upper.obj"
unit_scale = 0.00024
[device]
approach = [0.0, 0.0, 1.0]
)";

}  // namespace

std::optional<SceneDescription> casts_scene() {
  const char* shared = std::getenv("THIGMA_SHARED");
  if (shared == nullptr) return std::nullopt;
  const std::filesystem::path folder = std::filesystem::path(shared) / "meshes";
  if (!std::filesystem::exists(folder / "a01_dental_cast_upper.obj")) return std::nullopt;
  return parse_scene(kScene, "casts", folder.string());
}

}  // namespace thigma::experiments::level_choice
