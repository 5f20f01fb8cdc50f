#pragma once
// A connection with a VRPN server, of one device.

#include <cstdint>
#include <map>
#include <string>

#include "thigma/device/detail/link_device.h"
#include "thigma/device/detail/velocity_estimate.h"
#include "thigma/device/detail/vrpn_message.h"
#include "thigma/files/descriptor.h"

namespace thigma::detail {

/// What an address names.
struct VrpnAddress {
  std::string name, host;
  std::uint16_t port = 3883;
  int sensor = 0;
  Mat3 axes = Mat3::Identity();  // ours from the tracker's
  bool has_force = true;
  bool is_held = false;    // the hand always holds
  double radius = 0.02;    // of the force field [m]
  double max_force = 3.3;  // [N]
};

/// An open connection: what the server said last of the device. Thread: one at a time.
class VrpnLink {
 public:
  /// Connects and exchanges cookies and names.
  /// errors  DeviceUnavailable
  explicit VrpnLink(const VrpnAddress& address);

  /// Takes what has come.
  /// seconds  waits so long for a first byte
  /// returns  whether a pose was among it
  /// errors   IoError: closed, or nonsense
  bool hear_poses(double seconds);
  /// The newest pose and velocity [m, rad, s; our axes]; poses() counts them.
  const Motion& motion() const { return motion_; }
  std::uint64_t poses() const { return poses_; }
  std::uint32_t buttons() const { return buttons_; }
  /// What the server complained of, "" where of nothing.
  const char* complaint() const { return complaint_; }
  /// Names of the senders that the server told.
  std::string senders() const;
  bool knows_device() const;
  /// Of driver_time_ns, when anything came.
  std::int64_t last_heard() const { return last_heard_; }

  /// Sends a force about where the handle was [N, m; our axes]; a force of zero stops the field.
  /// errors   IoError
  void send_force(const Vec3& at, const Vec3& force);
  /// Asks for a sign of life.
  void ping();

 private:
  void shake_hands();
  void take(const VrpnMessage& message);
  void take_pose(const VrpnReport& report, double time);
  void take_velocity(const VrpnReport& report);
  void send(std::int32_t type, const std::string& payload);

  const VrpnAddress address_;
  Descriptor socket_;
  VrpnReader reader_;
  std::map<std::int32_t, std::string> senders_, types_;  // by the server's numbers
  Motion motion_;
  std::uint64_t poses_ = 0;
  std::uint32_t buttons_ = 0;
  const char* complaint_ = "";
  bool tells_velocity_ = false;
  std::int64_t last_heard_ = 0;
  VelocityEstimate velocity_;
  std::string in_, out_;
};

/// Speaks with the server until ends.is_over.
/// Thread   the link's own.
void speak_with_vrpn(VrpnLink& link, const VrpnAddress& address, LinkEnds& ends);

}  // namespace thigma::detail
