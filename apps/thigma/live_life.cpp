#include "live_life.h"

#include "thigma/session/rt_thread.h"

namespace thigma::app {

void wait_at_fault(live::LiveServer& server, const std::function<bool()>& is_over) {
  constexpr int kPatience = 500;  // polls
  int alone = server.page_count() > 0 ? 0 : kPatience;
  while (alone < kPatience && !is_over()) {
    alone = server.page_count() > 0 ? 0 : alone + 1;
    sleep_ns(kPagePoll);
  }
}

std::string tell_lost_recording(live::LiveServer& server, const std::string& file,
                                const RecordingFailure& failure) {
  server.observe(
      SessionEvent{failure.time, failure.frame, EventKind::recording_ended, file, failure.why});
  server.lose_recording();
  return failure.line();
}

}  // namespace thigma::app
