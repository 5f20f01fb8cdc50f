#include "thigma/device/detail/vrpn_link.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "thigma/core/error.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/open_device.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

constexpr double kPatience = 2.0;               // for the server's first words [s]
constexpr std::int64_t kQuiet = 40'000'000;     // poses this late are told of [ns]
constexpr std::int64_t kSilent = 500'000'000;   // and this late, a device with force is lost [ns]
constexpr std::int64_t kDead = 5'000'000'000;   // no sign of life [ns]
constexpr std::int64_t kPing = 1'000'000'000;   // between pings [ns]
constexpr std::int64_t kZeroTime = 25'000'000;  // zero is sent this long before the end [ns]
constexpr std::int64_t kLeastGap = 900'000;     // between forces [ns]

// Our numbers of types.
constexpr std::int32_t kForceField = 0, kPing0 = 1, kPong = 2;
constexpr const char* kOurTypes[] = {"vrpn_ForceDevice Force_Field", "vrpn_Base ping_message",
                                     "vrpn_Base pong_message"};

constexpr const char* kComplaints[] = {
    "the server says: a value is out of range", "the server says: its servo loop takes too long",
    "the server says: the largest force is exceeded, or the motors are too hot",
    "the server says that something is wrong"};
constexpr int kNoError = 4;

double server_time() {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

[[noreturn]] void refuse(const VrpnAddress& address, const std::string& what) {
  throw DeviceUnavailable("vrpn: " + address.host + ":" + std::to_string(address.port) + ": " +
                          what);
}

}  // namespace

VrpnLink::VrpnLink(const VrpnAddress& address)
    : address_(address), velocity_(1e-5, 1e-4, 0.015, 0.030) {
  std::string why;
  socket_ = connect_tcp(address.host, address.port, kPatience, why);
  if (!socket_.is_open())
    refuse(address, "no server answers (" + why + "). Start vrpn_server there.");
  shake_hands();
}

void VrpnLink::shake_hands() {
  std::string out = vrpn_cookie();
  append_vrpn_message({kVrpnSenderIs, 0, server_time(), vrpn_name_payload(address_.name)}, out);
  for (std::int32_t i = 0; i < 3; ++i)
    append_vrpn_message({kVrpnTypeIs, i, server_time(), vrpn_name_payload(kOurTypes[i])}, out);
  bool is_told = tell(socket_.get(), out, kPatience);
  const std::int64_t end = driver_time_ns() + static_cast<std::int64_t>(1e9 * kPatience);
  while (is_told && in_.size() < kVrpnCookie && driver_time_ns() < end) {
    if (hear(socket_.get(), 0.1, in_) == Heard::closed) break;
  }
  constexpr std::string_view kFront = "vrpn: ver. ";
  const std::size_t known = std::min(in_.size(), kFront.size());
  const bool is_cut = in_.size() < kVrpnCookie && in_.compare(0, known, kFront, 0, known) == 0;
  const std::string fault = in_.empty() ? "what is there says nothing"
                            : is_cut    ? "it stops in its first words"
                                        : fault_of_vrpn_cookie(in_);
  if (!fault.empty())
    refuse(address_, fault + ". Start vrpn_server of version 07 there, or name its port.");
  reader_.add(std::string_view(in_).substr(kVrpnCookie));
  in_.clear();
  last_heard_ = driver_time_ns();
}

std::string VrpnLink::senders() const {
  std::string names;
  for (const auto& [number, name] : senders_) {
    if (name != "VRPN Control") names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

bool VrpnLink::knows_device() const {
  for (const auto& [number, name] : senders_) {
    if (name == address_.name) return true;
  }
  return false;
}

bool VrpnLink::hear_poses(double seconds) {
  const std::uint64_t before = poses_;
  VrpnMessage message;
  in_.clear();
  const Heard heard = hear(socket_.get(), seconds, in_);
  if (heard == Heard::closed) throw IoError("the server has gone");
  if (heard == Heard::bytes) last_heard_ = driver_time_ns();
  reader_.add(in_);
  while (reader_.next(message)) take(message);
  if (reader_.is_broken()) throw IoError("the server says nonsense");
  return poses_ != before;
}

void VrpnLink::take(const VrpnMessage& message) {
  constexpr std::size_t kMostNames = 2000;
  if (message.type == kVrpnSenderIs || message.type == kVrpnTypeIs) {
    auto& names = message.type == kVrpnSenderIs ? senders_ : types_;
    std::string name;
    if (!read_vrpn_name(message.payload, name) || names.size() >= kMostNames)
      throw IoError("the server says nonsense");
    names[message.sender] = name;
    return;
  }
  const auto sender = senders_.find(message.sender);
  const auto type = types_.find(message.type);
  if (sender == senders_.end() || type == types_.end() || sender->second != address_.name) return;
  const std::string& kind = type->second;
  VrpnReport report;
  std::int32_t code = kNoError;
  bool is_right = true;
  if (kind == "vrpn_Tracker Pos_Quat") {
    is_right = read_vrpn_pose(message.payload, report);
    if (is_right && report.sensor == address_.sensor) take_pose(report, message.time);
  } else if (kind == "vrpn_Tracker Velocity") {
    is_right = read_vrpn_velocity(message.payload, report);
    if (is_right && report.sensor == address_.sensor) take_velocity(report);
  } else if (kind == "vrpn_Button Change") {
    is_right = read_vrpn_button(message.payload, buttons_);
  } else if (kind == "vrpn_Button States") {
    is_right = read_vrpn_buttons(message.payload, buttons_);
  } else if (kind == "vrpn_ForceDevice Force_Error") {
    is_right = read_vrpn_number(message.payload, code);
    if (is_right && code != kNoError) complaint_ = kComplaints[code >= 0 && code < 3 ? code : 3];
  } else if (kind == kOurTypes[kPing0]) {
    send(kPong, "");
  }
  if (!is_right) throw IoError("the server says nonsense");
}

void VrpnLink::take_pose(const VrpnReport& report, double time) {
  const double norm = report.quaternion.norm();
  if (!report.vector.allFinite() || !(std::abs(norm - 1.0) < 0.05))
    throw IoError("the server tells a pose that is none");
  motion_.pose.position = address_.axes * report.vector;
  const Vec3 axis = address_.axes * report.quaternion.vec() / norm;
  motion_.pose.orientation = Quat(report.quaternion.w() / norm, axis.x(), axis.y(), axis.z());
  const Twist& estimate = velocity_.update(time, motion_.pose);
  if (!tells_velocity_) motion_.twist.linear = estimate.linear;
  motion_.twist.angular = estimate.angular;
  ++poses_;
}

void VrpnLink::take_velocity(const VrpnReport& report) {
  if (!report.vector.allFinite()) throw IoError("the server tells a velocity that is none");
  motion_.twist.linear = address_.axes * report.vector;
  tells_velocity_ = true;
}

void VrpnLink::send(std::int32_t type, const std::string& payload) {
  out_.clear();
  append_vrpn_message({type, 0, server_time(), payload}, out_);
  if (!tell(socket_.get(), out_, 0.5)) throw IoError("the server takes nothing any more");
}

void VrpnLink::send_force(const Vec3& at, const Vec3& force) {
  const Mat3 back = address_.axes.transpose();
  const bool is_zero = force.isZero(0.0);
  send(kForceField, vrpn_force_field(is_zero ? Vec3(Vec3::Zero()) : Vec3(back * at), back * force,
                                     Mat3::Zero(), is_zero ? 0.0 : address_.radius));
}

void VrpnLink::ping() { send(kPing0, ""); }

namespace {

/// The link's thread, piece by piece.
class VrpnTalk {
 public:
  VrpnTalk(VrpnLink& link, const VrpnAddress& address, LinkEnds& ends)
      : link_(link), address_(address), ends_(ends) {}

  void run() {
    publish();
    std::int64_t over_since = 0;
    for (;;) {
      const std::int64_t now = driver_time_ns();
      const bool is_over = ends_.is_over.load(std::memory_order_acquire);
      if (over_since == 0 && (is_over || ends_.trouble.is_lost())) over_since = now;
      send(now);
      if (over_since != 0 && now - over_since > kZeroTime) return;
      if (link_.hear_poses(0.0005)) publish();
      look_at(driver_time_ns());
    }
  }

 private:
  void publish() {
    const std::int64_t now = driver_time_ns();
    LinkSample next = sample_;
    next.motion = link_.motion();
    next.buttons = address_.is_held ? kClutchButton | link_.buttons() << 1 : link_.buttons();
    next.interval = next.turn_interval = pace_.add(now);
    const double seconds = 1e-9 * static_cast<double>(now - last_pose_);
    const Pose &from = sample_.motion.pose, &to = next.motion.pose;
    if (address_.has_force && next.count > 0 &&
        (is_jump(from.position, to.position, seconds) ||
         is_jump(from.orientation, to.orientation, seconds)))
      return ends_.trouble.lose("the handle has jumped");
    ++next.count;
    last_pose_ = now;
    sample_ = next;
    ends_.samples.publish(sample_);
  }

  void look_at(std::int64_t now) {
    if (link_.buttons() != buttons_) {
      buttons_ = link_.buttons();
      if (!address_.has_force) publish();  // a tracker at rest may have nothing to say
    }
    if (*link_.complaint() != '\0') ends_.trouble.lose(link_.complaint());
    ends_.trouble.warn_while(address_.has_force && now - last_pose_ > kQuiet,
                             "the server tells its poses late");
    if (address_.has_force && now - last_pose_ > kSilent)
      ends_.trouble.lose("the server tells no pose any more");
    if (now - link_.last_heard() > kDead) ends_.trouble.lose("the server does not answer");
  }

  void send(std::int64_t now) {
    if (now - last_ping_ > kPing) {
      last_ping_ = now;
      link_.ping();
    }
    if (!address_.has_force || now - last_send_ < kLeastGap) return;
    const LinkCommand& command = force_.newest(ends_, now);
    link_.send_force(command.at, command.force);
    last_send_ = now;
  }

  VrpnLink& link_;
  const VrpnAddress& address_;
  LinkEnds& ends_;
  LinkForce force_;
  LinkSample sample_;
  Interval pace_;
  std::uint32_t buttons_ = 0;
  std::int64_t last_pose_ = 0, last_ping_ = 0, last_send_ = 0;
};

}  // namespace

void speak_with_vrpn(VrpnLink& link, const VrpnAddress& address, LinkEnds& ends) {
  try {
    VrpnTalk(link, address, ends).run();
  } catch (const IoError& error) {
    ends.trouble.lose(error.what());
    try {
      if (address.has_force) link.send_force(Vec3::Zero(), Vec3::Zero());
    } catch (const IoError&) {  // it is gone
    }
  }
}

}  // namespace thigma::detail
