#include "thigma/recording/recording.h"

#include <algorithm>
#include <concepts>
#include <cstdio>
#include <filesystem>

#include "thigma/core/error.h"
#include "thigma/dynamics/contact_model_fields.h"
#include "thigma/loop/sample_fields.h"
#include "thigma/recording/detail/foxglove.h"
#include "thigma/recording/detail/json_text.h"
#include "thigma/recording/mcap_file.h"

namespace thigma {
namespace {

using detail::JsonObject;

std::uint64_t nanoseconds(double seconds) {
  return seconds > 0.0 ? static_cast<std::uint64_t>(seconds * 1e9 + 0.5) : 0;
}

const char* status_name(DeviceStatus status) {
  switch (status) {
    case DeviceStatus::ok:
      return "ok";
    case DeviceStatus::not_ready:
      return "not_ready";
    case DeviceStatus::lost:
      return "lost";
    case DeviceStatus::finished:
      return "finished";
  }
  return "lost";
}

template <class Items, class Put>
void put_list(JsonObject& json, std::string& out, const char* key, const Items& items,
              const Put& put) {
  json.key(key);
  out += '[';
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += ',';
    put(out, items[i]);
  }
  out += ']';
}

void put_wrench(JsonObject& json, const char* force, const char* torque, const Wrench& wrench) {
  json.vector(force, wrench.force);
  json.vector(torque, wrench.torque);
}

/// Writes the fields of a list (sample_fields.h) into an object.
struct FieldWriter {
  std::string& out;
  JsonObject& json;

  void operator()(const char* key, double value) const { json.number(key, value); }
  void operator()(const char* key, float value) const {
    json.number(key, static_cast<double>(value));
  }
  void operator()(const char* key, bool value) const { json.flag(key, value); }
  template <std::integral Integer>
  void operator()(const char* key, Integer value) const {
    json.integer(key, static_cast<long long>(value));
  }
  void operator()(const char* key, Fault value) const { json.word(key, fault_name(value)); }
  void operator()(const char* key, DeviceStatus value) const { json.word(key, status_name(value)); }
  void operator()(const char* key, RowKind value) const {
    json.integer(key, static_cast<long long>(value));
  }
  template <class Vector>
  void vector(const char* key, const Vector& v) const {
    json.vector(key, v);
  }
  void pose(const Pose& pose) const { json.pose(pose); }
  void twist(const Twist& twist) const { json.twist(twist); }
  void wrench(const char* force, const char* torque, const Wrench& wrench) const {
    put_wrench(json, force, torque, wrench);
  }
  void body(const BodyState& body) const {
    json.pose({body.position, body.orientation});
    json.vector("linear_momentum", body.linear_momentum);
    json.vector("angular_momentum", body.angular_momentum);
  }
  void motion(const char* key, const Motion& motion) const {
    json.key(key);
    JsonObject inner(out);
    inner.pose(motion.pose);
    inner.twist(motion.twist);
    inner.close();
  }
  template <class Value>
  void unless(const char* key, Value value, Value usual) const {
    if (value != usual) (*this)(key, value);
  }
  void unless_zero(const char* key, const Vec3& v) const {
    if ((v.array() != 0.0).any()) vector(key, v);
  }
  void pressing(const char* key, const PressingRows& rows) const {
    if (rows.empty()) return;
    put_list(json, out, key, rows, [](std::string& text, const PressingRow& pressing) {
      JsonObject row(text);
      row.word("id", hex_text(pressing.id));
      row.vector("force", pressing.force);
      row.close();
    });
  }
  void optional_pose(const char* key, bool has, const Pose& pose) const {
    if (!has) return;
    json.key(key);
    JsonObject inner(out);
    inner.pose(pose);
    inner.close();
  }
  void digest(const char* key, std::uint64_t value) const { json.word(key, hex_text(value)); }
  /// Up to the last level that has any.
  void counts(const char* key, const LevelCounts& counts) const {
    std::size_t used = counts.size();
    while (used > 0 && counts[used - 1] == 0) --used;
    json.key(key);
    out += '[';
    for (std::size_t i = 0; i < used; ++i) {
      if (i > 0) out += ',';
      out += std::to_string(counts[i]);
    }
    out += ']';
  }
};

void put_device(std::string& out, const HapticSample& s) {
  JsonObject json(out);
  visit_device_state(s, FieldWriter{out, json});
  json.close();
}

/// One of the messages of a frame that begin with its number and time.
template <class Fields>
void put_of_frame(std::string& out, const HapticSample& s, Fields fields) {
  JsonObject json(out);
  json.integer("frame", static_cast<long long>(s.frame));
  json.number("time", s.time);
  fields(FieldWriter{out, json});
  json.close();
}

void put_command(std::string& out, const HapticSample& s) {
  put_of_frame(out, s, [&](const FieldWriter& w) { visit_device_command(s, w); });
}

void put_state(std::string& out, const HapticSample& s) {
  put_of_frame(out, s, [&](const FieldWriter& w) { visit_body_state(s, w); });
}

void put_timing(std::string& out, const HapticSample& s) {
  put_of_frame(out, s, [&](const FieldWriter& w) { visit_timing(s, w); });
}

void put_plane(std::string& out, const PlaneTerm& p) {
  JsonObject json(out);
  visit_plane(p, FieldWriter{out, json});
  json.close();
}

void put_depth(std::string& out, const DepthTerm& t) {
  JsonObject json(out);
  visit_depth(t, FieldWriter{out, json});
  json.close();
}

void put_row(std::string& out, const ContactRow& r) {
  JsonObject json(out);
  visit_row(r, FieldWriter{out, json});
  json.close();
}

void put_constraints(JsonObject& json, std::string& out, const ConstraintModel& constraints) {
  json.key("constraints");
  JsonObject inner(out);
  inner.number("travel", constraints.travel);
  inner.number("reach", constraints.reach);
  put_list(inner, out, "rows", constraints.rows, put_row);
  inner.close();
}

void put_model(std::string& out, const ContactSample& sample) {
  const LinearContactModel& model = sample.model;
  JsonObject json(out);
  json.integer("sequence", static_cast<long long>(model.sequence));
  json.number("time", model.time);
  FieldWriter{out, json}.body(model.state);
  put_list(json, out, "planes", model.planes, put_plane);
  put_list(json, out, "depths", model.depths, put_depth);
  if (model.constraints.reach > 0.0) put_constraints(json, out, model.constraints);
  json.word("model_digest", hex_text(sample.model_digest));
  json.close();
}

void put_frame(std::string& out, const ContactSample& c) {
  JsonObject json(out);
  json.integer("sequence", static_cast<long long>(c.model.sequence));
  visit_contact_frame(c, FieldWriter{out, json});
  visit_contact_levels(c, FieldWriter{out, json});
  visit_contact_rows(c, FieldWriter{out, json});
  json.close();
}

}  // namespace

std::string hex_text(std::uint64_t bits) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(bits));
  return text;
}

RecordingWriter::RecordingWriter(const std::string& path, const std::string& config)
    : file_(std::make_unique<McapWriter>(path)),
      config_(file_->add_channel("/config", "thigma.Config", "")),
      device_(file_->add_channel("/device/state", "thigma.DeviceState", "")),
      command_(file_->add_channel("/device/command", "thigma.DeviceCommand", "")),
      body_(file_->add_channel("/body/state", "thigma.BodyState", "")),
      timing_(file_->add_channel("/timing", "thigma.Timing", "")),
      model_(file_->add_channel("/contact/model", "thigma.ContactModel", "")),
      frame_(file_->add_channel("/contact/frame", "thigma.ContactFrame", "")),
      events_(file_->add_channel("/events", "thigma.Event", "")),
      transforms_(
          file_->add_channel("/tf", detail::kTransformsSchemaName, detail::transforms_schema())),
      scene_(file_->add_channel("/scene", detail::kSceneSchemaName, detail::scene_schema())) {
  try {
    file_->write(config_, 0, 0, config);
    file_->flush();  // without it nothing that follows can be read
  } catch (...) {
    file_->discard();
    throw;
  }
}

const std::string& RecordingWriter::moved() const { return file_->moved(); }

RecordingWriter::~RecordingWriter() {
  if (!is_open_) return;
  try {
    file_->flush();
    if (has_frames()) file_->close();
  } catch (...) {  // what was flushed is in the part
  }
  if (!has_frames()) file_->discard();
}

/// More than the configuration and the surfaces has been flushed.
bool RecordingWriter::has_frames() const { return file_->messages() > preface_; }

/// Whether it is time for another picture; then `last` is when.
bool RecordingWriter::is_next_picture(double time, double& last) const {
  if (last >= 0.0 && time >= last && time - last < 1.0 / detail::kPicturesPerSecond) return false;
  last = time;
  return true;
}

/// Closes the file after an error; says how much of the session is where.
std::string RecordingWriter::keep_early() {
  if (!has_frames()) {
    file_->discard();
    return "; nothing was recorded";
  }
  const std::string place = file_->close_early();
  if (std::error_code unknown; !std::filesystem::exists(place, unknown)) return "";
  char text[64];
  std::snprintf(text, sizeof text, "; the first %.3f s are in ",
                1e-9 * static_cast<double>(file_->last_time()));
  return text + place;
}

template <class Work>
void RecordingWriter::attempt(Work work) {
  if (!is_open_) return;
  try {
    work();
  } catch (const IoError& error) {
    is_open_ = false;
    throw IoError(error.what() + keep_early());
  }
}

void RecordingWriter::attach(const McapAttachment& file) {
  attempt([&] { file_->attach(file); });
}

void RecordingWriter::write(const RecordedSurface& surface) {
  if (surface.is_object && !surface.positions.empty()) {
    radius_ = 0.0;
    for (const Vec3& p : surface.positions) radius_ = std::max(radius_, p.norm());
  }
  text_.clear();
  detail::put_surface(text_, surface);
  ++preface_;
  attempt([&] { file_->write(scene_, picture_count_++, 0, text_); });
}

void RecordingWriter::write(const HapticSample& sample) {
  const std::uint64_t time = nanoseconds(sample.time);
  const std::uint32_t sequence = static_cast<std::uint32_t>(sample.frame);
  const auto put = [&](std::uint16_t channel, void (*encode)(std::string&, const HapticSample&)) {
    text_.clear();
    encode(text_, sample);
    file_->write(channel, sequence, time, text_);
  };
  attempt([&] {
    put(device_, put_device);
    put(command_, put_command);
    put(body_, put_state);
    put(timing_, put_timing);
  });
  last_time_ = sample.time;
  if (!is_next_picture(sample.time, last_picture_)) return;
  attempt([&] {
    text_.clear();
    detail::put_transforms(text_, time, sample);
    file_->write(transforms_, picture_count_, time, text_);
    text_.clear();
    detail::put_force(text_, time, sample, radius_);
    file_->write(scene_, picture_count_++, time, text_);
  });
}

void RecordingWriter::write(const ContactSample& sample) {
  const std::uint64_t time = nanoseconds(sample.published);
  const auto put = [&](std::uint16_t channel, void (*encode)(std::string&, const ContactSample&)) {
    text_.clear();
    encode(text_, sample);
    file_->write(channel, contact_count_, time, text_);
  };
  attempt([&] {
    put(model_, put_model);
    put(frame_, put_frame);
  });
  ++contact_count_;
  if (!is_next_picture(sample.published, last_contacts_)) return;
  attempt([&] {
    text_.clear();
    detail::put_contacts(text_, time, sample, radius_);
    file_->write(scene_, picture_count_++, time, text_);
  });
}

void RecordingWriter::write(const SessionEvent& event) {
  text_.clear();
  JsonObject json(text_);
  json.number("time", event.time);
  json.integer("frame", static_cast<long long>(event.frame));
  json.word("event", event_name(event.kind));
  if (!event.detail.empty())
    json.word(event.kind == EventKind::fault ? "fault" : "detail", event.detail);
  json.close();
  attempt([&] { file_->write(events_, event_count_++, nanoseconds(event.time), text_); });
}

void RecordingWriter::close(const RecordingEnd& end) {
  text_.clear();
  JsonObject json(text_);
  json.number("time", last_time_);
  json.word("event", "end");
  json.integer("frames", static_cast<long long>(end.frames));
  json.word("state_hash", hex_text(end.state_hash));
  json.integer("dropped", static_cast<long long>(end.dropped));
  json.close();
  attempt([&] {
    file_->write(events_, event_count_++, nanoseconds(last_time_), text_);
    file_->close();
  });
  is_open_ = false;
}

}  // namespace thigma
