#pragma once
// Messages of VRPN 07 as bytes: what a tracker, buttons and a force device need. Source: the public
// source of VRPN 07.38, vrpn_Connection.C, vrpn_Tracker.C, vrpn_Button.C, vrpn_ForceDevice.C.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/math/pose.h"

namespace thigma::detail {

/// Types of messages that say what numbers mean; a connection's own types are from 0 on.
inline constexpr std::int32_t kVrpnSenderIs = -1, kVrpnTypeIs = -2;

inline constexpr std::size_t kVrpnCookie = 24;  // bytes that both sides send first

/// Our cookie: the version, and that nothing is to be logged.
std::string vrpn_cookie();

/// What is wrong with the other side's, one line; "" where nothing is.
std::string fault_of_vrpn_cookie(std::string_view cookie);

struct VrpnMessage {
  std::int32_t type = 0, sender = 0;
  double time = 0.0;  // of the server's clock, since 1970 [s]
  std::string payload;
};

/// Appends one; of the time, microseconds are kept.
void append_vrpn_message(const VrpnMessage& message, std::string& out);

/// Makes messages of what a server sends. Invariant: holds one message of at most 64 KiB and what
/// was added. Thread: one.
class VrpnReader {
 public:
  void add(std::string_view bytes) { in_.append(bytes); }
  /// The next message; false where more bytes are needed, or it is broken.
  bool next(VrpnMessage& message);
  /// A length that no message has: nothing is read from here on.
  bool is_broken() const { return is_broken_; }

 private:
  std::string in_;
  bool is_broken_ = false;
};

/// Payload of a message that gives its sender's number a name.
std::string vrpn_name_payload(const std::string& name);

/// A name out of such a payload; false where it is none.
bool read_vrpn_name(std::string_view payload, std::string& name);

/// A report of a tracker: a pose [m; the tracker's axes], or a velocity.
struct VrpnReport {
  std::int32_t sensor = 0;
  Vec3 vector = Vec3::Zero();          // position [m] or velocity [m/s]
  Quat quaternion = Quat::Identity();  // orientation, or the turn within `time`; as it came
  double time = 0.0;                   // [s]; of a velocity
};

/// False where a payload is none, or too short. Numbers may be anything.
bool read_vrpn_pose(std::string_view payload, VrpnReport& report);
bool read_vrpn_velocity(std::string_view payload, VrpnReport& report);

/// Changes the bits of buttons by a report of one ("Change") or of all ("States"); false where it
/// is none. Buttons beyond 31 are left out.
bool read_vrpn_button(std::string_view payload, std::uint32_t& buttons);
bool read_vrpn_buttons(std::string_view payload, std::uint32_t& buttons);

/// A 32-bit number; false where there is none.
bool read_vrpn_number(std::string_view payload, std::int32_t& number);

/// Payload of a local force field: force + jacobian (x - origin) within the radius, and nothing
/// beyond it [N, N/m, m; the tracker's axes].
std::string vrpn_force_field(const Vec3& origin, const Vec3& force, const Mat3& jacobian,
                             double radius);

}  // namespace thigma::detail
