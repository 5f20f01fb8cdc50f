#include <sstream>

#include "fuzz/fuzz_target.h"

#include "thigma/device/script.h"

namespace thigma::fuzz {

void fuzz_script(Bytes bytes) {
  std::vector<TimedPose> rows;
  std::istringstream text{std::string(text_of(bytes))};
  if (!is_taken("script", [&] { rows = parse_script(text, "script"); })) return;
  require(!rows.empty(), "a script has a row");
  for (std::size_t i = 1; i < rows.size(); ++i)
    require(rows[i].time > rows[i - 1].time, "times increase");
  ScriptCursor cursor;
  const double first = rows.front().time, last = rows.back().time;
  for (int i = -2; i < 20; ++i) {
    const Motion m = script_motion(rows, first + (last - first) * i / 17.0, cursor);
    require(m.pose.orientation.coeffs().allFinite(), "orientations are finite");
  }
}

}  // namespace thigma::fuzz
