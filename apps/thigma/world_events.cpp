#include "world_events.h"

#include <cstdio>

#include "thigma/core/index.h"

namespace thigma::app {
namespace {

constexpr double kWindow = 2.0;  // in which it is judged how fast a world goes [s]
constexpr double kSlow = 0.8;    // slower is told

}  // namespace

WorldEvents::WorldEvents(const LoadedWorld& world, live::LiveServer& server)
    : rate_(world.config.rate), server_(server), held_(world.config.hands.size()) {
  use(world);
}

void WorldEvents::use(const LoadedWorld& world) {
  names_.clear();
  for (const WorldBody& body : world.config.world.bodies) names_.push_back(body.name);
}

void WorldEvents::observe(const WorldFrame& frame) {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const std::int32_t body = frame.grips[i].body;
    const std::string& now = body < 0 ? nobody_ : names_[idx(body)];
    if (now == held_[i]) continue;
    if (!held_[i].empty()) tell(frame, EventKind::released, held_[i], "");
    if (body >= 0) tell(frame, EventKind::grasped, now, "");
    held_[i] = now;
  }
  lost_ += static_cast<double>(frame.lost) / rate_;
  if (frame.time < since_ + kWindow) return;
  const double pace = (frame.time - since_) / (frame.time - since_ + lost_);
  since_ = frame.time;
  lost_ = 0.0;
  if (pace > kSlow) return;
  char text[96];
  std::snprintf(text, sizeof text, "the world goes at %.0f %% of the clock's pace", 100.0 * pace);
  tell(frame, EventKind::late, "", text);
}

void WorldEvents::tell(const WorldFrame& frame, EventKind kind, const std::string& detail,
                       const std::string& text) {
  server_.observe(SessionEvent{frame.time, frame.frame, kind, detail, text});
}

}  // namespace thigma::app
