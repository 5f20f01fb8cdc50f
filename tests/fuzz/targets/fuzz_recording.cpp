#include "fuzz/fuzz_target.h"

#include "thigma/files/byte_source.h"
#include "thigma/recording/config_json.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"

namespace thigma::fuzz {
namespace {

/// "What is missing or damaged is a difference", never a failure.
void replay(const Recording& recording) {
  RecordedConfig config;
  try {
    config = read_config(recording.config);
  } catch (const InputError&) {
    return;
  }
  const ReplayReport report =
      replay_session(config.params, config.world_from_body, recording.frames, recording.contacts);
  require(report.frames == recording.frames.size(), "every frame is run again");
}

}  // namespace

void fuzz_recording(Bytes bytes) {
  MemorySource source(text_of(bytes));
  is_taken("file", [&] {
    for (const McapAttachment& file : read_attachments(source, "file"))
      require(file.data.size() <= bytes.size(), "no attachment is longer than its file");
  });
  Recording recording;
  std::vector<SamplePlace> places;
  if (!is_taken("file", [&] { recording = read_recording(source, "file"); })) return;
  McapMessages messages(source);
  require(recording.frames.size() == recording.frame_count, "frames are counted");
  stream_recording(
      source, "file",
      {{}, [&](const HapticSample&, const SamplePlace& p) { places.push_back(p); }, {}});
  require(places.size() == recording.frames.size(), "a second pass finds the same");
  constexpr std::size_t kFew = 50;
  if (places.size() > kFew) return;
  for (std::size_t i = 0; i < places.size(); ++i)
    require(read_frame_at(messages, places[i]).frame == recording.frames[i].frame,
            "a frame is where it was");
  replay(recording);
}

}  // namespace thigma::fuzz
