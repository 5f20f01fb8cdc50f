#include "thigma/files/file.h"
#include "thigma/recording/detail/csv_row.h"
#include "thigma/recording/world_frames.h"

namespace thigma {
namespace {

using detail::CsvNames;
using detail::CsvValues;

constexpr std::size_t kMostBytes = 1 << 20;  // that wait to be written

/// As in the topics: "device", "device 2".
std::string device_name(std::size_t device) {
  return device == 0 ? "device" : "device " + std::to_string(device + 1);
}

template <class Visit>
void visit_body(const BodyState& y, const std::optional<bool>& is_asleep, Visit& visit) {
  visit.vector("", " [m]", y.position);
  visit.vector("q", "", y.orientation.coeffs());
  visit.vector("P", " [kg m/s]", y.linear_momentum);
  visit.vector("L", " [kg m^2/s]", y.angular_momentum);
  if (is_asleep)
    visit("asleep", *is_asleep ? 1 : 0);
  else
    visit.absent("asleep");
}

template <class Visit>
void visit_joint(const RecordedJoint& joint, Visit& visit) {
  visit("coordinate [m or rad]", joint.coordinate);
  visit("spring [N or N m]", joint.spring);
  visit("motor [N or N m]", joint.motor);
  visit("limit [N or N m]", joint.limit);
}

template <class Visit>
void visit_device(const DeviceState& device, Visit& visit) {
  visit.vector("", " [m]", device.motion.pose.position);
  visit.vector("q", "", device.motion.pose.orientation.coeffs());
  visit("buttons", device.buttons);
}

template <class Visit>
void visit_command(const Wrench& wrench, Visit& visit) {
  visit.vector("command f", " [N]", wrench.force);
  visit.vector("command t", " [N m]", wrench.torque);
}

template <class Visit>
void visit_hand(const std::optional<RecordedHand>& hand, const Wrench& command, Visit& visit) {
  if (hand) {
    visit_device(hand->device, visit);
  } else {
    visit.absent_vector("", " [m]", Vec3());
    visit.absent_vector("q", "", Vec4());
    visit.absent("buttons");
  }
  visit_command(command, visit);
  if (hand)
    visit("energy [J]", hand->energy);
  else
    visit.absent("energy [J]");
}

template <class Visit>
void visit_frame(const RecordedWorldFrame& f, const WorldRecordingInfo& info, Visit visit) {
  visit("frame", f.frame);
  visit("time [s]", f.time);
  for (std::size_t i = 0; i < f.bodies.size(); ++i) {
    visit.group("body " + info.bodies[i]);
    visit_body(f.bodies[i], f.is_asleep[i], visit);
  }
  for (std::size_t i = 0; i < f.joints.size(); ++i) {
    visit.group("joint " + info.joints[i]);
    visit_joint(f.joints[i], visit);
  }
  for (std::size_t i = 0; i < f.commands.size(); ++i) {
    visit.group(device_name(i));
    visit_hand(f.hands[i], f.commands[i], visit);
  }
}

template <class Visit>
void visit_tick(const HandTick& tick, Visit visit) {
  visit("device number", tick.hand + 1);
  visit("step", tick.step);
  visit("time [s]", tick.tick.now);
  visit("elapsed [s]", tick.tick.elapsed);
  visit.group("device");
  visit_device(tick.device, visit);
  visit_command(tick.sent, visit);
  visit("energy [J]", tick.energy);
  visit.group("");
  visit("world frame", tick.news);
  visit("external fault", tick.tick.external_fault);
}

void write_full(std::string& rows, FileWriter& file, std::size_t most) {
  if (rows.size() < most) return;
  file.append(rows);
  rows.clear();
}

}  // namespace

WorldCsvExport::WorldCsvExport(const std::string& path, const WorldRecordingInfo& info)
    : file_(std::make_unique<FileWriter>(path)), info_(info) {
  RecordedWorldFrame frame;
  frame.bodies.resize(info.bodies.size());
  frame.is_asleep.resize(info.bodies.size());
  frame.joints.resize(info.joints.size());
  frame.commands.resize(info.devices.size());
  frame.hands.resize(info.devices.size());
  visit_frame(frame, info_, CsvNames(rows_));
  rows_ += '\n';
}

WorldCsvExport::~WorldCsvExport() = default;

void WorldCsvExport::add(const RecordedWorldFrame& frame) {
  visit_frame(frame, info_, CsvValues(rows_));
  rows_ += '\n';
  write_full(rows_, *file_, kMostBytes);
}

void WorldCsvExport::keep() {
  write_full(rows_, *file_, 0);
  file_->keep();
}

HapticCsvExport::HapticCsvExport(const std::string& path)
    : file_(std::make_unique<FileWriter>(path)) {
  visit_tick(HandTick{}, CsvNames(rows_));
  rows_ += '\n';
}

HapticCsvExport::~HapticCsvExport() = default;

void HapticCsvExport::add(const HandTick& tick) {
  visit_tick(tick, CsvValues(rows_));
  rows_ += '\n';
  write_full(rows_, *file_, kMostBytes);
}

void HapticCsvExport::keep() {
  write_full(rows_, *file_, 0);
  file_->keep();
}

}  // namespace thigma
