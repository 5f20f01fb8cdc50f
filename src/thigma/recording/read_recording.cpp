#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/core/one_line.h"
#include "thigma/files/byte_source.h"
#include "thigma/recording/detail/cut_text.h"
#include "thigma/recording/detail/recorded_messages.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"

namespace thigma {
namespace {

using detail::BegunSamples;
using Json = nlohmann::json;

std::string where_text(const std::string& path, const std::string& topic,
                       const McapMessage& message) {
  return path + ": message " + std::to_string(message.sequence) + " of " + topic + ", " +
         place_text(message.place) + ", ";
}

/// Puts the samples together and tells of each when its last message has been read, or the first of
/// the next.
struct Assembly {
  const std::string& path;
  const RecordingSinks& sinks;
  RecordingInfo info{};
  BegunSamples begun{};
  SamplePlace frame_place{}, contact_place{};
  bool has_frame = false, has_contact = false;  // the last one, whole

  void end_frame() {
    if (!begun.frame) return;
    ++info.frame_count;
    info.last_time = begun.frame->time;
    if (sinks.frame) sinks.frame(*begun.frame, frame_place);
    begun.frame.reset();
  }
  void end_contact() {
    if (!begun.contact) return;
    ++info.contact_count;
    if (sinks.contact) sinks.contact(*begun.contact, contact_place);
    begun.contact.reset();
  }

  bool take(const std::string& topic, const McapMessage& message) {
    if (topic == "/device/state") {
      end_frame();
      frame_place = {};
    }
    if (topic == "/contact/model") {
      end_contact();
      contact_place = {};
    }
    try {
      detail::read_message(topic, message.data, info, begun);
    } catch (const Json::exception& error) {
      fail(topic, message, error.what());
    } catch (const InputError& error) {
      fail(topic, message, error.what());
    }
    if (begun.frame)
      note(topic, {"/device/state", "/device/command", "/body/state", "/timing"}, message,
           frame_place);
    if (begun.contact) note(topic, {"/contact/model", "/contact/frame"}, message, contact_place);
    if (topic == "/timing") has_frame = true;
    if (topic == "/device/state") has_frame = false;
    if (topic == "/contact/frame") has_contact = true;
    if (topic == "/contact/model") has_contact = false;
    return topic != "/config" || !sinks.config || sinks.config(info.config);
  }

  /// What was begun and not ended is left out, unless the recording says that it is whole.
  void finish() {
    if (info.has_end || has_frame) end_frame();
    if (info.has_end || has_contact) end_contact();
  }

 private:
  void note(const std::string& topic, std::initializer_list<std::string_view> topics,
            const McapMessage& message, SamplePlace& place) {
    std::size_t i = 0;
    for (const std::string_view name : topics) {
      if (name == topic) place.messages[i] = message.place;
      ++i;
    }
  }
  [[noreturn]] void fail(const std::string& topic, const McapMessage& message, const char* why) {
    throw InputError(
        one_line(where_text(path, topic, message) + "expected a recording of thigma: " + why));
  }
};

RecordingInfo stream(ByteSource& source, const std::string& path, const RecordingSinks& sinks) {
  Assembly assembly{path, sinks};
  bool is_enough = false;
  McapScan scan = scan_mcap(source, path, [&](const McapScan& file, const McapMessage& message) {
    is_enough = !assembly.take(file.topics[static_cast<std::size_t>(message.channel)], message);
    return !is_enough;
  });
  RecordingInfo& info = assembly.info;
  info.warnings = std::move(scan.warnings);
  if (is_enough) return std::move(info);
  if (info.config.empty()) {
    throw InputError(
        path + ": no /config message" +
        (scan.cut.empty() ? "" : ", byte " + std::to_string(scan.end) + ": " + scan.cut) +
        ", expected a recording of thigma");
  }
  assembly.finish();
  if (!info.has_end || !scan.cut.empty()) {
    info.cut_off = detail::cut_text(info.last_time, info.frame_count, scan);
    info.warnings.push_back(info.cut_off);
  }
  return std::move(info);
}

/// Sinks that keep everything in `recording`.
RecordingSinks keepers(Recording& recording) {
  return {
      {},
      [&recording](const HapticSample& s, const SamplePlace&) { recording.frames.push_back(s); },
      [&recording](const ContactSample& s, const SamplePlace&) {
        recording.contacts.push_back(s);
      }};
}

}  // namespace

RecordingInfo stream_recording(ByteSource& source, const std::string& path,
                               const RecordingSinks& sinks) {
  return stream(source, path, sinks);
}

RecordingInfo stream_recording(const std::string& path, const RecordingSinks& sinks) {
  refuse_absent_recording(path);
  FileSource source(path);
  return stream(source, path, sinks);
}

Recording read_recording(const std::string& path) {
  Recording recording;
  RecordingInfo info = stream_recording(path, keepers(recording));
  static_cast<RecordingInfo&>(recording) = std::move(info);
  return recording;
}

Recording read_recording(ByteSource& source, const std::string& path) {
  Recording recording;
  RecordingInfo info = stream_recording(source, path, keepers(recording));
  static_cast<RecordingInfo&>(recording) = std::move(info);
  return recording;
}

HapticSample read_frame_at(McapMessages& messages, const SamplePlace& place) {
  BegunSamples begun;
  RecordingInfo info;
  const char* const topics[] = {"/device/state", "/device/command", "/body/state", "/timing"};
  for (std::size_t i = 0; i < 4; ++i) {
    if (place.messages[i].is_none()) continue;
    detail::read_message(topics[i], messages.data(place.messages[i]), info, begun);
  }
  return *begun.frame;
}

ContactSample read_contact_at(McapMessages& messages, const SamplePlace& place) {
  BegunSamples begun;
  RecordingInfo info;
  const char* const topics[] = {"/contact/model", "/contact/frame"};
  for (std::size_t i = 0; i < 2; ++i) {
    if (place.messages[i].is_none()) continue;
    detail::read_message(topics[i], messages.data(place.messages[i]), info, begun);
  }
  return *begun.contact;
}

std::vector<std::string> recording_warnings(const std::string& path, const RecordingInfo& info) {
  std::vector<std::string> lines;
  for (const std::string& warning : info.warnings) lines.push_back(path + ": " + warning);
  return lines;
}

}  // namespace thigma
