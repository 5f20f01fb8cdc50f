#include "thigma/scene/record_session.h"

#include "thigma/recording/config_json.h"
#include "thigma/recording/recording.h"

namespace thigma {

RecordedConfig recorded_config(const SceneSession& session, bool is_lockstep) {
  const SessionConfig& config = session.config;
  RecordedConfig recorded;
  recorded.params = config.haptic;
  recorded.world_from_body = config.world_from_body;
  recorded.rate_hz = config.rate;
  recorded.is_lockstep = is_lockstep;
  recorded.is_simulated = session.simulation != nullptr;
  recorded.resolution = config.contact.resolution;
  for (std::size_t i = 0; i < config.contact.friction.size(); ++i)
    recorded.friction.push_back(friction_on(config.contact, static_cast<std::int32_t>(i)));
  recorded.seed = session.seed;
  recorded.scene = session.scene_file;
  recorded.device = session.device_uri;
  return recorded;
}

SessionSinks recording_sinks(RecordingWriter& writer) {
  return {[&writer](const HapticSample& sample) { writer.write(sample); },
          [&writer](const ContactSample& sample) { writer.write(sample); },
          [&writer](const SessionEvent& event) { writer.write(event); }};
}

SessionSummary record_lockstep(SceneSession& session, const std::string& path,
                               const std::atomic<bool>* stop) {
  RecordingWriter writer(path, write_config(recorded_config(session, true)));
  const SessionSummary summary = run_lockstep(session, recording_sinks(writer), stop);
  writer.close({summary.frames, summary.state_hash, summary.dropped_samples});
  return summary;
}

}  // namespace thigma
