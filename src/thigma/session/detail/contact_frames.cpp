#include "thigma/session/detail/contact_frames.h"

#include "thigma/session/rt_thread.h"

namespace thigma::detail {

void timed_contact_step(const ContactWorld& world, const StampedBody& body,
                        ContactFrames& frames) noexcept {
  const std::int64_t begin = thread_cpu_ns();
  find_contacts(world, body, frames.scratch);
  const std::int64_t found = thread_cpu_ns();
  make_model(world, body, frames.scratch, frames.sample);
  const std::int64_t end = thread_cpu_ns();
  frames.sample.query_cpu = 1e-9 * static_cast<double>(found - begin);
  frames.sample.step_cpu = 1e-9 * static_cast<double>(end - begin);
}

void record_contacts(double published, ContactFrames& frames) noexcept {
  frames.sample.published = published;
  accumulate(frames.statistics, frames.sample);
}

void show_contacts(LivePorts* live, const ContactWorld& world, double time,
                   const ContactFrames& frames) noexcept {
  if (live == nullptr) return;
  view_contacts(world, frames.scratch, time, live->contacts.draft());
  live->contacts.publish();
}

}  // namespace thigma::detail
