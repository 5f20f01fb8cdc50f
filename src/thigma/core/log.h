#pragma once
// Lines for people.

#include <functional>
#include <string>

namespace thigma {

/// Takes a line of progress or a notice, without its end; may be empty. Never called by a real-time
/// thread.
using Log = std::function<void(const std::string& line)>;

}  // namespace thigma
