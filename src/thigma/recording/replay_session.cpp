#include "thigma/recording/replay_session.h"

#include <bit>
#include <deque>
#include <optional>
#include <utility>

#include "thigma/core/error.h"
#include "thigma/recording/config_json.h"
#include "thigma/recording/recording.h"

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

bool same_bits(const Wrench& a, const Wrench& b) noexcept {
  return same_bits(a.force, b.force) && same_bits(a.torque, b.torque);
}

struct SessionReplay::Impl {
  HapticParams params;
  RecordedDevice device;
  std::unique_ptr<Latest<LinearContactModel>> exchange =
      std::make_unique<Latest<LinearContactModel>>();
  HapticState state;
  ReplayReport report{};
  StateHash replayed_hash{}, recorded_hash{};
  std::uint64_t sequence = 0;  // of the model in use
  std::deque<ContactSample> models{};
  std::deque<HapticSample> waiting{};

  Impl(const HapticParams& p, const Pose& world_from_body)
      : params(p), device(p.device), state(initial_state(p, world_from_body)) {}

  void note(std::uint64_t frame, std::string reason) {
    if (report.first_difference >= 0 || reason.empty()) return;
    report.first_difference = static_cast<std::int64_t>(frame);
    report.reason = std::move(reason);
  }

  void use_model(const HapticSample& recorded) {
    sequence = recorded.model_sequence;
    while (!models.empty() && models.front().model.sequence < sequence) models.pop_front();
    const std::string name = "contact model " + std::to_string(sequence);
    if (models.empty() || models.front().model.sequence != sequence) {
      note(recorded.frame, name + " is missing");
      return;
    }
    const ContactSample& found = models.front();
    if (found.model_digest != 0 && found.model_digest != model_digest(found.model))
      note(recorded.frame, name + " is not the one that was recorded");
    exchange->publish(found.model);
  }

  void step(const HapticSample& recorded) {
    if (recorded.model_sequence != sequence) use_model(recorded);
    device.next = recorded.device;
    const HapticPorts ports{&device, exchange.get(), nullptr, nullptr};
    const HapticSample replayed = haptic_step(
        params, ports, {recorded.time, recorded.elapsed, recorded.external_fault}, state);
    note(recorded.frame, difference(recorded, replayed));
    add_frame(replayed_hash, replayed.body, replayed.command);
    add_frame(recorded_hash, recorded.body, recorded.command);
    ++report.frames;
  }

  bool has_come(std::uint64_t wanted) const {
    return wanted == sequence || (!models.empty() && models.back().model.sequence >= wanted);
  }

  void step_waiting(std::size_t most) {
    while (!waiting.empty() &&
           (waiting.size() > most || has_come(waiting.front().model_sequence))) {
      step(waiting.front());
      waiting.pop_front();
    }
  }
};

SessionReplay::SessionReplay(const HapticParams& params, const Pose& world_from_body)
    : impl_(std::make_unique<Impl>(params, world_from_body)) {}
SessionReplay::~SessionReplay() = default;

void SessionReplay::add(const ContactSample& model) {
  impl_->models.push_back(model);
  // That many before the first frame that uses one: no session writes such a recording.
  if (impl_->models.size() > kMostWaiting) impl_->models.pop_front();
  impl_->step_waiting(kMostWaiting);
}

void SessionReplay::add(const HapticSample& sample) {
  impl_->waiting.push_back(sample);
  impl_->step_waiting(kMostWaiting);
}

ReplayReport SessionReplay::finish() {
  impl_->step_waiting(0);
  ReplayReport report = impl_->report;
  report.state_hash = impl_->replayed_hash.value;
  report.recorded_hash = impl_->recorded_hash.value;
  report.identical = report.first_difference < 0 && report.state_hash == report.recorded_hash;
  return report;
}

ReplayReport replay_session(const HapticParams& params, const Pose& world_from_body,
                            const std::vector<HapticSample>& samples,
                            const std::vector<ContactSample>& models) {
  SessionReplay replay(params, world_from_body);
  for (const ContactSample& model : models) replay.add(model);
  for (const HapticSample& sample : samples) replay.add(sample);
  return replay.finish();
}

ReplayReport replay_recording(const std::string& path) {
  std::optional<SessionReplay> replay;
  RecordingSinks sinks;
  sinks.config = [&](const std::string& text) {
    const RecordedConfig config = read_config(text, path);
    if (config.is_simulated)
      throw InputError(path + ": of a simulated body, expected a session of a device");
    replay.emplace(config.params, config.world_from_body);
    return true;
  };
  const auto begun = [&]() -> SessionReplay& {
    if (!replay)
      throw InputError(path + ": no /config message before the first frame, expected one");
    return *replay;
  };
  sinks.frame = [&](const HapticSample& sample, const SamplePlace&) { begun().add(sample); };
  sinks.contact = [&](const ContactSample& sample, const SamplePlace&) { begun().add(sample); };
  stream_recording(path, sinks);
  return begun().finish();
}

}  // namespace thigma
