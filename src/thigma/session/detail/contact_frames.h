#pragma once
// The contact frames of a session: one step after the other, timed and added up.

#include "thigma/loop/contact_step.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/session.h"
#include "thigma/session/statistics.h"

namespace thigma::detail {

/// What contact frames work on and add up to. Thread: one.
struct ContactFrames {
  ContactScratch scratch;
  ContactSample sample;  // of the last frame
  ContactStatistics statistics;
};

/// contact_step with its CPU time in the sample.
/// Thread    [contact].
void timed_contact_step(const ContactWorld& world, const StampedBody& body,
                        ContactFrames& frames) noexcept;

/// Stamps the sample of a frame and adds it up; published [s; session clock].
/// Thread    [contact].
void record_contacts(double published, ContactFrames& frames) noexcept;

/// Shows a frame's contacts to whoever watches; null: nobody does. time: of the body state they
/// were found for [s].
/// Thread    [contact].
void show_contacts(LivePorts* live, const ContactWorld& world, double time,
                   const ContactFrames& frames) noexcept;

}  // namespace thigma::detail
