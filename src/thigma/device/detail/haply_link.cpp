#include "thigma/device/detail/haply_link.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <random>

#include "thigma/core/error.h"
#include "thigma/device/detail/haply_device.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr double kPatience = 2.0;               // for what a service answers while it is opened [s]
constexpr double kQuiet = 0.040;                // an answer this late is told of [s]
constexpr double kSilent = 0.500;               // and this late, the device is lost [s]
constexpr std::int64_t kZeroTime = 25'000'000;  // zero is sent this long before the end [ns]

std::string place_of(const HaplyAddress& address) {
  return address.host + ":" + std::to_string(address.port);
}

[[noreturn]] void refuse(const HaplyAddress& address, const std::string& what) {
  throw DeviceUnavailable("haply: " + place_of(address) + ": " + what);
}

Descriptor connect(const HaplyAddress& address) {
  std::string why;
  Descriptor s = connect_tcp(address.host, address.port, kPatience, why);
  if (!s.is_open())
    refuse(address, "no Inverse Service answers (" + why +
                        "). Start the Haply Hub, or `systemctl start haply-inverse-service`.");
  return s;
}

/// What comes until `is_whole`, or the other side closes, or time is over.
std::string hear_until(int fd, const std::function<bool(const std::string&)>& is_whole) {
  constexpr std::size_t kMost = 64 * 1024;
  std::string text;
  const std::int64_t last = driver_time_ns() + static_cast<std::int64_t>(1e9 * kPatience);
  while (text.size() < kMost && !is_whole(text)) {
    const double left = 1e-9 * static_cast<double>(last - driver_time_ns());
    if (left <= 0.0 || hear(fd, left, text) == Heard::closed) break;
  }
  return text;
}

bool has_head(const std::string& text) { return text.find("\r\n\r\n") != std::string::npos; }

/// An answer with its body.
std::string hear_http(int fd) {
  return hear_until(fd, [](const std::string& text) {
    const std::size_t end = text.find("\r\n\r\n");
    if (end == std::string::npos) return false;
    const std::string_view head = std::string_view(text).substr(0, end + 2);
    const std::string length(http_header(head, "Content-Length"));
    if (length.empty()) return false;  // until it is closed
    return text.size() >= end + 4 + std::strtoul(length.c_str(), nullptr, 10);
  });
}

}  // namespace

const HaplyArm* find_arm(const HaplyFrame& frame, const std::string& id) {
  for (const HaplyArm& arm : frame.arms) {
    if (id.empty() || arm.id == id) return &arm;
  }
  return nullptr;
}

const HaplyGrip* find_grip(const HaplyFrame& frame, const std::string& id) {
  if (id == "none") return nullptr;
  for (const HaplyGrip& grip : frame.grips) {
    if (id.empty() || grip.id == id) return &grip;
  }
  return nullptr;
}

HaplyLink::HaplyLink(const HaplyAddress& address) {
  mask_ = std::random_device()();
  ask_for_version(address);
  shake_hands(address);
  try {
    if (!wait(kPatience)) refuse(address, "the service says nothing. Restart it.");
  } catch (const IoError& error) {
    refuse(address, std::string(error.what()) + ". Is it the Inverse Service? Restart it.");
  }
}

void HaplyLink::ask_for_version(const HaplyAddress& address) {
  const Descriptor s = connect(address);
  tell(s.get(),
       "GET /version HTTP/1.1\r\nHost: " + place_of(address) + "\r\nConnection: close\r\n\r\n",
       kPatience);
  const std::string answer = hear_http(s.get());
  if (answer.rfind("HTTP/1.", 0) != 0)
    refuse(address, "what answers is no Inverse Service. Set its port with ?port=.");
  const std::size_t body = answer.find("\r\n\r\n");
  const std::string text = body == std::string::npos ? "" : answer.substr(body + 4);
  const std::string fault = haply_form_of(text, form_);
  if (!fault.empty()) refuse(address, fault + ". Install an Inverse Service of version 3.");
}

void HaplyLink::shake_hands(const HaplyAddress& address) {
  socket_ = connect(address);
  std::random_device random;
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string key;
  for (int i = 0; i < 21; ++i) key += kLetters[random() % 64];
  key += "A==";  // 128 bits
  tell(socket_.get(), websocket_request(place_of(address), key), kPatience);
  const std::string answer = hear_until(socket_.get(), has_head);
  const std::size_t end = answer.find("\r\n\r\n");
  const std::string fault =
      end == std::string::npos
          ? "it does not answer the WebSocket handshake"
          : fault_of_websocket_answer(std::string_view(answer).substr(0, end + 2), key);
  if (!fault.empty())
    refuse(address, fault + ". Is it the Inverse Service? Set its port with ?port=.");
  reader_.add(std::string_view(answer).substr(end + 4));
}

void HaplyLink::send_frame(WebSocketOp op, std::string_view payload) {
  // Any mask will do against caches, which are not between us and this machine.
  mask_ = mask_ * 1664525u + 1013904223u;
  out_.clear();
  append_websocket_frame(op, payload, mask_, out_);
  if (!tell(socket_.get(), out_, kSilent)) throw IoError("the service takes nothing any more");
}

void HaplyLink::send(const std::string& id, const Vec3& force) {
  send_frame(WebSocketOp::text, haply_force_message(form_, id, force, is_first_));
  is_first_ = false;
}

bool HaplyLink::wait(double seconds) {
  const std::int64_t end = driver_time_ns() + static_cast<std::int64_t>(1e9 * seconds);
  for (;;) {
    switch (reader_.next(text_)) {
      case WebSocketEvent::text: {
        const std::string fault = read_haply_frame(text_, frame_);
        if (!fault.empty()) throw IoError("the service says nonsense: " + fault);
        return true;
      }
      case WebSocketEvent::ping:
        send_frame(WebSocketOp::pong, std::string(text_));
        continue;
      case WebSocketEvent::close:
        throw IoError("the service has closed the connection");
      case WebSocketEvent::broken:
        throw IoError(std::string("the service says nonsense: ") + reader_.fault());
      case WebSocketEvent::none:
        break;
    }
    const double left = 1e-9 * static_cast<double>(end - driver_time_ns());
    if (left <= 0.0) return false;
    std::string bytes;
    const Heard heard = hear(socket_.get(), left, bytes);
    if (heard == Heard::closed) throw IoError("the service has gone");
    reader_.add(bytes);
  }
}

void HaplyLink::close() noexcept {
  constexpr std::string_view kNormal = "\x03\xe8";  // 1000
  out_.clear();
  append_websocket_frame(WebSocketOp::close, kNormal, mask_, out_);
  tell(socket_.get(), out_, 0.1);
  socket_ = Descriptor();
}

namespace {

/// What a message says becomes a sample.
class HaplySamples {
 public:
  HaplySamples(const HaplyAddress& address, LinkEnds& ends) : address_(address), ends_(ends) {}

  /// now of driver_time_ns
  void take(const HaplyFrame& frame, std::int64_t now) {
    const HaplyArm* arm = find_arm(frame, address_.id);
    if (arm == nullptr) return ends_.trouble.lose("the device is not there any more: unplugged");
    if (!arm->is_calibrated) return ends_.trouble.lose("the device has lost its calibration");
    ends_.trouble.warn_while(!arm->has_power,
                             "the device has no power supply: its forces are weak");
    if (!arm->is_ready) return ends_.trouble.lose("the device is not ready any more");
    LinkSample next = sample_;
    next.motion.pose.position = ours_from_haply(arm->position);
    next.motion.twist.linear = ours_from_haply(arm->velocity);
    take_grip(find_grip(frame, address_.grip), now, next);
    const double seconds = 1e-9 * static_cast<double>(now - last_);
    if (next.count > 0 && is_jump(sample_.motion.pose.position, next.motion.pose.position, seconds))
      return ends_.trouble.lose("the handle has jumped");
    next.interval = pace_.add(now);
    ++next.count;
    last_ = now;
    sample_ = next;
    ends_.samples.publish(sample_);
  }

 private:
  void take_grip(const HaplyGrip* grip, std::int64_t now, LinkSample& next) {
    const bool is_held = address_.hold == 1;
    next.buttons = is_held ? kClutchButton : 0;
    ends_.trouble.warn_while(grip == nullptr && address_.grip != "none",
                             "the VerseGrip is gone: the handle turns no more");
    if (grip == nullptr) return;
    if (is_held) next.buttons |= grip->buttons << 1;
    if (!is_held) next.buttons |= grip->buttons;
    if (!grip->has_orientation) return;
    const Quat turn = ours_from_haply(grip->orientation);
    if (turn.coeffs() == next.motion.pose.orientation.coeffs()) return;
    const double seconds = 1e-9 * static_cast<double>(now - last_turn_);
    if (last_turn_ != 0 && is_jump(next.motion.pose.orientation, turn, seconds))
      ends_.trouble.lose("the VerseGrip's orientation has jumped");
    next.motion.pose.orientation = turn;
    next.turn_interval = turn_pace_.add(now);
    last_turn_ = now;
  }

  const HaplyAddress& address_;
  LinkEnds& ends_;
  LinkSample sample_;
  Interval pace_, turn_pace_;
  std::int64_t last_ = 0, last_turn_ = 0;
};

void exchange(HaplyLink& link, const HaplyAddress& address, LinkEnds& ends) {
  HaplySamples samples(address, ends);
  LinkForce force;
  const auto period = static_cast<std::int64_t>(1e9 / address.rate);
  std::int64_t due = driver_time_ns(), over_since = 0;
  samples.take(link.frame(), due);
  for (;;) {
    const std::int64_t now = driver_time_ns();
    if (over_since == 0 && ends.is_over.load(std::memory_order_acquire)) over_since = now;
    if (over_since != 0 && now - over_since > kZeroTime) return;
    if (ends.trouble.is_lost() && over_since == 0) over_since = now;
    link.send(address.id, haply_from_ours(force.newest(ends, now).force));
    const bool is_late = !link.wait(kQuiet);
    ends.trouble.warn_while(is_late, "the service answers late");
    if (is_late) {
      link.send(address.id, Vec3::Zero());  // what it reads last when it wakes up
      for (int owed = 2; owed > 0; --owed) {
        if (!link.wait(kSilent)) throw IoError("the service does not answer");
      }
    }
    samples.take(link.frame(), driver_time_ns());
    due = std::max(due + period, driver_time_ns() - period);
    wait_until_ns(due);
  }
}

}  // namespace

void speak_with_haply(HaplyLink& link, const HaplyAddress& address, LinkEnds& ends) {
  try {
    exchange(link, address, ends);
  } catch (const IoError& error) {
    ends.trouble.lose(error.what());
    try {
      link.send(address.id, Vec3::Zero());
    } catch (const IoError&) {  // it is gone
    }
  }
  link.close();
}

}  // namespace thigma::detail
