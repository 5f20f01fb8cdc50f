#pragma once
// `thigma run` with its page: sessions one after the other, as the page asks for them.

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "run_options.h"
#include "run_session.h"

#include "thigma/device/web_device.h"
#include "thigma/recording/recording.h"
#include "thigma/session/session.h"

namespace thigma::app {

/// What a live run needs of the program around it.
struct LiveProgram {
  std::unique_ptr<Run>* run = nullptr;      // of the session; the page may ask for another
  WebDeviceChannel* web_channel = nullptr;  // between the page and the device web:
  const RunOptions* options = nullptr;
  std::uint64_t seed = 1;
  const std::atomic<bool>* stop = nullptr;  // set by Ctrl-C
  // A recording of the session that `run` holds, under this path; throws IoError.
  std::function<std::unique_ptr<RecordingWriter>(const std::string& path)> record;
  std::function<void(const HapticSample&)> observe_haptic;  // on the draining thread; may be empty
  std::function<void(const ContactSample&)> observe_contact;  // likewise
  std::function<void()> poll;                                 // every 10 ms; may be empty
  std::function<void(const std::string&)> log;                // a line for people
  // one that --quiet does not take away; any thread
  std::function<void(const std::string&)> print_trouble;
};

/// Serves the page and runs sessions until the time is over, the device has finished, a fault has
/// ended one with nobody there to begin again, or it is told to stop.
///
/// returns  of the last session
/// errors   PortUnavailable, IoError, std::system_error
/// Thread   [offline]
SessionSummary run_live(const LiveProgram& program);

}  // namespace thigma::app
