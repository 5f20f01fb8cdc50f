#include "world_recorder.h"

#include "verbs.h"

#include "thigma/core/error.h"
#include "thigma/device/web_device.h"
#include "thigma/scene/packed_world.h"

namespace thigma::app {
namespace {

WorldRecordingInfo info_of(const LoadedWorld& world, const WorldRecorderInfo& given) {
  WorldRecordingInfo info;
  info.scene = given.scene;
  info.devices = given.devices;
  info.seed = given.seed;
  info.rate = world.config.rate;
  info.friction = given.friction;
  info.is_apart = given.is_apart;
  if (given.is_apart) info.limits = given.limits;
  for (const WorldBody& body : world.config.world.bodies) info.bodies.push_back(body.name);
  for (const WorldJoint& joint : world.config.world.joints) info.joints.push_back(joint.name);
  return info;
}

/// The scene travels with its recording.
std::vector<McapAttachment> packed(const WorldSceneDescription& scene) {
  try {
    return pack_world(scene);
  } catch (const InputError& error) {
    print_error(std::string(error.what()) + "; the recording goes without its scene");
    return {};
  }
}

class RecordedPage final : public HapticDevice {
 public:
  explicit RecordedPage(const std::vector<RecordedHand>& samples)
      : samples_(samples), limits_(make_web_device(link_)->limits()) {}

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "recorded page"; }
  DeviceState read(double) THIGMA_RT override {
    if (next_ < samples_.size()) return samples_[next_++].device;
    DeviceState state;
    state.status = DeviceStatus::finished;
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  const std::vector<RecordedHand>& samples_;  // outlive the device
  WebDeviceChannel link_;
  DeviceLimits limits_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<DeviceLimits> limits_of(const std::vector<HapticDevice*>& devices) {
  std::vector<DeviceLimits> limits;
  for (const HapticDevice* device : devices)
    limits.push_back(device != nullptr ? device->limits() : DeviceLimits{});
  return limits;
}

WorldRecorder::WorldRecorder(const std::string& path, const LoadedWorld& world,
                             const WorldRecorderInfo& info)
    : writer_(path, info_of(world, info)),
      joints_(world.config.world.joints.size()),
      hands_(info.devices.size()) {
  for (const McapAttachment& file : packed(world.description)) writer_.attach(file);
}

void WorldRecorder::write(const WorldFrame& frame) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointReading& joint = frame.joints[i];
    joints_[i] = {joint.coordinate, joint.spring, joint.motor, joint.limit};
  }
  const WorldHapticNow& haptic = frame.haptic;
  for (std::size_t i = 0; i < hands_.size(); ++i) {
    hands_[i] = {frame.grips[i].device, frame.aimed};
    hands_[i].energy = frame.grips[i].energy;
    if (haptic.ticks > 0) hands_[i].seen = haptic.seen[i];
  }
  writer_.write(frame.frame, frame.time, frame.bodies, joints_,
                haptic.ticks > 0 ? haptic.sent : frame.commands, hands_, frame.is_asleep);
}

void WorldRecorder::close(const WorldSummary& summary) {
  std::vector<std::uint64_t> steps;
  for (const WorldHapticSummary& hand : summary.haptic) steps.push_back(hand.steps);
  writer_.close(summary.frames, summary.state_hash, steps);
}

void use_friction(double friction, WorldSceneDescription& scene) {
  for (WorldSceneBody& body : scene.bodies) {
    if (!body.object.material) body.object.material = Material{};
    body.object.material->friction = {friction, friction};
  }
}

RecordedApart apart_of(const WorldRecording& recording) {
  RecordedApart apart;
  apart.ticks = recording.ticks;
  for (const std::vector<RecordedHand>& hand : recording.hands) {
    apart.seen.emplace_back();
    for (const RecordedHand& one : hand) apart.seen.back().push_back(one.seen);
  }
  return apart;
}

void add_recorded_hands(const std::vector<std::string>& devices, LoadedWorld& world) {
  std::vector<WorldHand>& hands = world.config.hands;
  for (std::size_t i = 0; i < devices.size() && i <= hands.size(); ++i) {
    if (!is_page_hand(devices[i])) continue;
    if (i == hands.size())
      hands.push_back(free_hand(world));
    else
      hands[i] = free_hand(world);
  }
}

std::unique_ptr<HapticDevice> recorded_hand(const std::vector<RecordedHand>& samples) {
  return std::make_unique<RecordedPage>(samples);
}

}  // namespace thigma::app
