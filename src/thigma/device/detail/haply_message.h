#pragma once
// What the Inverse Service of Haply says and is told: JSON. Source: its documentation, versions 3.1
// to 3.5.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/math/types.h"

namespace thigma::detail {

/// One Inverse3, Inverse3x or Minverse.
struct HaplyArm {
  std::string id;
  Vec3 position = Vec3::Zero();  // of the cursor [m; x right, y away from the person, z up]
  Vec3 velocity = Vec3::Zero();  // [m/s]
  // status; true where a frame does not say
  bool is_calibrated = true, is_ready = true, has_power = true;
  // of the first frame only
  std::string type;
  bool has_own_axes = false;  // basis or mount are not the device's own: other axes or units
};

/// One VerseGrip, wired or wireless.
struct HaplyGrip {
  std::string id;
  Quat orientation = Quat::Identity();  // [axes of the arm]
  bool has_orientation = false, has_buttons = false;
  std::uint32_t buttons = 0;  // bit 0: a, 1: b, 2: c
};

/// What one message says.
struct HaplyFrame {
  std::vector<HaplyArm> arms;
  std::vector<HaplyGrip> grips;  // wireless ones first
};

/// Reads one message of the service.
///
/// text     JSON
/// frame    what it says; valid where nothing is wrong
/// returns  what is wrong, one line; "" where nothing is
/// Thread   [offline].
std::string read_haply_frame(std::string_view text, HaplyFrame& frame);

/// How a force is named: 3.1 to 3.4 say "values", 3.5 says "vector".
enum class HaplyForm : std::uint8_t { values, vector };

/// The form of a service from its answer to GET /version.
///
/// answer   body: JSON with a "version", or the number alone
/// form     where it is known
/// returns  what is wrong, one line: no number, or a version that is not 3.1 to 3.x; "" otherwise
/// Thread   [offline].
std::string haply_form_of(std::string_view answer, HaplyForm& form);

/// A command: this force, until the next one.
///
/// force     [N; axes of the service]
/// is_first  with the name of the program, as the first message of a connection has it
/// Thread    [offline].
std::string haply_force_message(HaplyForm form, const std::string& id, const Vec3& force,
                                bool is_first);

}  // namespace thigma::detail
