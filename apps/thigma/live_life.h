#pragma once
// What the sessions of a live run have in common, those of one object and those of a world.

#include <cstdint>
#include <functional>
#include <string>

#include "guarded_writer.h"
#include "viewer/server/live_server.h"

namespace thigma::app {

constexpr std::int64_t kPagePoll = 10'000'000;  // from one look at pages' requests to the next [ns]

/// Who is looking at a fault may begin again, and may load the page anew; without anybody there for
/// five seconds it is over.
///
/// is_over   looks at pages' requests; true ends the wait
void wait_at_fault(live::LiveServer& server, const std::function<bool()>& is_over);

/// The session goes on; pages are told once. Returns the line for people.
///
/// file   of the recording
std::string tell_lost_recording(live::LiveServer& server, const std::string& file,
                                const RecordingFailure& failure);

}  // namespace thigma::app
