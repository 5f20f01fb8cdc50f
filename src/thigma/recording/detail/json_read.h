#pragma once
// The inverse of json_text.h: vectors and poses out of parsed JSON.

#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/math/pose.h"

namespace thigma::detail {

/// What a null among numbers means: recordings write NaN so, a configuration has none.
enum class NullNumber : std::uint8_t { refused, not_a_number };

inline double read_number(const nlohmann::json& value, NullNumber null) {
  if (null == NullNumber::not_a_number && value.is_null())
    return std::numeric_limits<double>::quiet_NaN();
  return value.get<double>();
}

/// As many numbers as `out` has. Throws InputError, or what the JSON library throws.
template <class Vector>
void read_vector(const nlohmann::json& json, const char* key, Vector& out, NullNumber null) {
  const nlohmann::json& list = json.at(key);
  if (!list.is_array() || list.size() != static_cast<std::size_t>(out.size())) {
    throw InputError(std::string("'") + key + "' has not " + std::to_string(out.size()) +
                     " numbers");
  }
  for (std::size_t i = 0; i < list.size(); ++i)
    out[static_cast<int>(i)] = read_number(list[i], null);
}

inline void read_pose(const nlohmann::json& json, Pose& pose, NullNumber null) {
  read_vector(json, "position", pose.position, null);
  Vec4 q = pose.orientation.coeffs();
  read_vector(json, "quat_xyzw", q, null);
  pose.orientation.coeffs() = q;
}

}  // namespace thigma::detail
