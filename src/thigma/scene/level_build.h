#pragma once
// Levels of detail that are built beside a session, which has begun at full resolution without
// them.

#include <memory>
#include <string>

#include "thigma/scene/load_scene.h"
#include "thigma/session/live_ports.h"

namespace thigma {

/// A scene being loaded with its levels, in a thread of its own that gives way to all others.
/// Invariant: the thread uses nothing of the scene it was made for. Thread: one.
class LevelBuild {
 public:
  /// description  as load_scene took it
  /// options      of load_scene; log and progress are called by the thread, defers_levels is off
  /// wait         before it begins, so that what a person waits for is done first [s]
  LevelBuild(SceneDescription description, LoadOptions options, double wait = 0.0);
  ~LevelBuild();  // gives up, within a step of the build
  LevelBuild(const LevelBuild&) = delete;
  LevelBuild& operator=(const LevelBuild&) = delete;

  /// What is built is not wanted any more; returns at once.
  void give_up();
  /// Whether there is a result, or it has been given up.
  bool is_over() const;
  /// The scene with all its levels, once; after is_over().
  /// errors   as load_scene
  Scene take();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What the contact thread of a session needs to go on with the surfaces of another loading of its
/// scene: all but the surfaces, their levels and the resolution stays as it is. Its first query has
/// been made, so that the one in the session is as quick as any.
///
/// now      of the session, as it began
/// scene    the same scene with its levels; outlives the session
/// near     where the object about is: world_from_body
/// Thread   [offline]; errors as use_constraints
std::unique_ptr<ContactReplacement> replace_contacts(const SessionConfig& now, const Scene& scene,
                                                     const BodyState& near);

}  // namespace thigma
