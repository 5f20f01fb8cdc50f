#include "thigma/runtime/replay_session.h"

#include <algorithm>
#include <bit>
#include <memory>

namespace thigma {
namespace {

/// Gives the samples of a recording one by one.
class RecordedDevice final : public HapticDevice {
 public:
  explicit RecordedDevice(const DeviceLimits& limits) : limits_(limits) {}
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "recorded"; }
  DeviceState read(double) THIGMA_RT override { return next; }
  void write(const Wrench&) THIGMA_RT override {}

  DeviceState next;

 private:
  DeviceLimits limits_;
};

bool same_bits(const Vec3& a, const Vec3& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  }
  return true;
}

bool same_bits(const Quat& a, const Quat& b) {
  for (int i = 0; i < 4; ++i) {
    if (std::bit_cast<std::uint64_t>(a.coeffs()[i]) != std::bit_cast<std::uint64_t>(b.coeffs()[i]))
      return false;
  }
  return true;
}

bool same_bits(const Wrench& a, const Wrench& b) {
  return same_bits(a.force, b.force) && same_bits(a.torque, b.torque);
}

const ContactSample* find_model(const std::vector<ContactSample>& models, std::uint64_t sequence) {
  const auto found = std::lower_bound(models.begin(), models.end(), sequence,
                                      [](const ContactSample& sample, std::uint64_t wanted) {
                                        return sample.model.sequence < wanted;
                                      });
  return found != models.end() && found->model.sequence == sequence ? &*found : nullptr;
}

/// Why a replayed frame is not the recorded one; "" when it is.
std::string difference(const HapticSample& recorded, const HapticSample& replayed) {
  if (recorded.frame != replayed.frame) return "frames are missing";
  if (recorded.input_digest != 0 && recorded.input_digest != replayed.input_digest)
    return "the device sample is not the one that was recorded";
  if (!same_bits(recorded.body, replayed.body)) return "body state";
  if (!same_bits(recorded.command, replayed.command)) return "device wrench";
  if (recorded.fault != replayed.fault) return "fault";
  return {};
}

}  // namespace

bool same_bits(const BodyState& a, const BodyState& b) noexcept {
  return same_bits(a.position, b.position) && same_bits(a.orientation, b.orientation) &&
         same_bits(a.linear_momentum, b.linear_momentum) &&
         same_bits(a.angular_momentum, b.angular_momentum);
}

ReplayReport replay_session(const HapticParams& params, const Pose& world_from_body,
                            const std::vector<HapticSample>& samples,
                            const std::vector<ContactSample>& models) {
  RecordedDevice device(params.device);
  const auto exchange = std::make_unique<Latest<LinearContactModel>>();
  const HapticPorts ports{&device, exchange.get(), nullptr, nullptr};
  HapticState state = initial_state(params, world_from_body);
  ReplayReport report;
  StateHash replayed_hash, recorded_hash;
  std::uint64_t sequence = 0;
  const auto note = [&report](std::uint64_t frame, std::string reason) {
    if (report.first_difference >= 0 || reason.empty()) return;
    report.first_difference = static_cast<std::int64_t>(frame);
    report.reason = std::move(reason);
  };
  for (const HapticSample& recorded : samples) {
    if (recorded.model_sequence != sequence) {
      sequence = recorded.model_sequence;
      const ContactSample* found = find_model(models, sequence);
      if (found == nullptr) {
        note(recorded.frame, "contact model " + std::to_string(sequence) + " is missing");
      } else {
        if (found->model_digest != 0 && found->model_digest != model_digest(found->model)) {
          note(recorded.frame,
               "contact model " + std::to_string(sequence) + " is not the one that was recorded");
        }
        exchange->publish(found->model);
      }
    }
    device.next = recorded.device;
    const HapticSample replayed = haptic_step(
        params, ports, {recorded.time, recorded.elapsed, recorded.external_fault}, state);
    note(recorded.frame, difference(recorded, replayed));
    add_frame(replayed_hash, replayed.body, replayed.command);
    add_frame(recorded_hash, recorded.body, recorded.command);
    ++report.frames;
  }
  report.state_hash = replayed_hash.value;
  report.recorded_hash = recorded_hash.value;
  report.identical = report.first_difference < 0 && report.state_hash == report.recorded_hash;
  return report;
}

}  // namespace thigma
