#pragma once
// What a running session and those who watch it exchange: contacts to look at, gains that change,
// pauses. Nothing here makes a real-time thread wait.

#include <atomic>
#include <cstdint>
#include <optional>

#include "thigma/contact/contact.h"
#include "thigma/core/latest.h"
#include "thigma/core/static_vector.h"
#include "thigma/loop/contact_step.h"
#include "thigma/loop/haptic_step.h"

namespace thigma {

/// Most contacts of a frame that are shown.
inline constexpr std::size_t kViewedContacts = 128;

/// A contact as it is shown: Contact with nodes in place of patches.
struct ViewedContact {
  Vec3 point = Vec3::Zero();                       // on the object [m; world]
  Vec3 normal = Vec3::UnitZ();                     // out of the object [world]
  double depth = 0.0;                              // > 0 penetrating [m]
  double bound = 0.0;                              // [m]
  std::int32_t body = -1;                          // static object
  std::int32_t object_node = -1, scene_node = -1;  // of the hierarchies; -1: not of one
  std::uint8_t object_level = 0, scene_level = 0;
  ContactStatus status = ContactStatus::separated;
  LevelDecision decided_by = LevelDecision::finest;
};

/// The contacts of one frame, or a sample of them where there are too many.
struct ContactView {
  double time = 0.0;           // of the body state they were found for [s]
  std::uint64_t sequence = 0;  // of the model made of them
  std::int64_t found = 0, dropped = 0, front = 0;
  StaticVector<ViewedContact, kViewedContacts> contacts;
};
static_assert(RtPayload<ContactView>);

/// Fills a view from the contacts that scratch holds: all of them, or every n-th and the deepest
/// one of each cluster.
/// Thread    [contact].
void view_contacts(const ContactWorld& world, const ContactScratch& scratch, double time,
                   ContactView& view) noexcept;

/// Gains of the haptic thread that may change while it runs.
struct HapticTuning {
  RigidBody body;
  Coupling coupling;  // grasp frame and is_grasped are left as they are
};
static_assert(RtPayload<HapticTuning>);

/// Puts a tuning into effect between two steps. Velocities stay, so momenta go with the mass.
/// Thread    [haptic].
void apply_tuning(const HapticTuning& tuning, HapticParams& params, HapticState& state) THIGMA_RT;

/// Gains and resolution of the contact thread that may change while it runs.
struct ContactTuning {
  PenaltyParams response;
  Resolution resolution;  // is_exact is left as it is, and exact queries read nothing of it
  std::optional<double> most_friction{};  // as of ContactWorld
};
static_assert(RtPayload<ContactTuning>);

/// Puts a tuning into effect between two contact frames.
/// Thread    [contact].
void apply_tuning(const ContactTuning& tuning, ContactWorld& world) noexcept;

/// Surfaces that take the place of those a session runs on, with the working memory for them; made
/// by replace_contacts (scene/level_build.h).
struct ContactReplacement {
  ContactWorld world;
  ContactScratch scratch;  // ready for the first frame
};

/// How long levels of detail that come into a session take to be as coarse as asked: contacts go
/// through their levels one by one, each when its turn comes, as in motion [s; session clock].
inline constexpr double kLevelsFadeIn = 2.0;

/// Exchanges the surfaces of a running session for others between two contact frames. What was
/// there is in `other` afterwards; clusters, their ids and the count of models go on.
/// Thread    [contact]: nothing in here allocates or frees.
void exchange_contacts(ContactReplacement& other, ContactWorld& world,
                       ContactScratch& scratch) noexcept;

/// The resolution while levels fade in: thresholds at this share of what is asked.
/// share    0: the finest surfaces; from 1 on as asked
/// Thread    [contact].
Resolution faded_in(const Resolution& asked, double share) noexcept;

/// What the hand of a page takes hold of, in a world of several bodies.
struct WorldAim {
  std::int32_t body = -1;     // -1: nothing
  Vec3 point = Vec3::Zero();  // where [m; body frame]
  std::uint32_t world = 0;    // whose numbers these are: changes of the session's world before
};
static_assert(RtPayload<WorldAim>);

/// The exchanges themselves; they outlive the session. Lockstep sessions publish views and ignore
/// the rest, as nothing may change what they compute.
/// Thread: each exchange has one writer and one reader, named beside it.
struct LivePorts {
  Latest<ContactView> contacts;          // contact thread -> watcher
  Latest<HapticTuning> haptic_tuning;    // watcher -> haptic thread
  Latest<ContactTuning> contact_tuning;  // watcher -> contact thread
  // watcher -> contact thread, which makes it null when it is done; what it points to, and the
  // surfaces of either, outlive the session
  std::atomic<ContactReplacement*> replacement{nullptr};
  // watcher -> haptic thread: session time stands still, but not that of a device that holds a
  // person
  std::atomic<bool> is_paused{false};
  std::atomic<int> steps{0};  // watcher -> haptic thread: frames to do while paused
  Latest<WorldAim> aim;       // watcher -> the thread of a world, which reads no tuning
};

/// Takes one of the frames asked for while paused; false when there is none.
/// Thread    [haptic].
bool take_step(LivePorts& live) THIGMA_RT;

}  // namespace thigma
