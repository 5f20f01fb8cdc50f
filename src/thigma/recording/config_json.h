#pragma once
// What a recording keeps of its session, so that the haptic frames can be run again without the
// scene's meshes.

#include <string>
#include <vector>

#include "thigma/contact/resolution.h"
#include "thigma/loop/contact_world.h"
#include "thigma/loop/haptic_step.h"

namespace thigma {

/// Everything constant that the haptic frames depend on, and where they came from.
struct RecordedConfig {
  HapticParams params;
  Pose world_from_body;  // of the centre of mass, before the first frame
  double rate_hz = 1000.0;
  bool is_lockstep = false;
  // nobody held the object: frames are those of the simulation of the scene
  bool is_simulated = false;
  Resolution resolution;           // of the contact query; the haptic frames do not depend on it
  std::vector<Friction> friction;  // on each static body; the models have it, too
  std::uint64_t seed = 1;
  std::string scene;   // as given on the command line; printable
  std::string device;  // its name
};

/// One line of JSON; every double comes back with the same bits. Thread [offline].
std::string write_config(const RecordedConfig& config);

/// The inverse. Thread [offline]; throws InputError "what is wrong" (the caller adds the file).
RecordedConfig read_config(const std::string& json);

/// The same of the recording of that name, which messages begin with.
RecordedConfig read_config(const std::string& json, const std::string& path);

}  // namespace thigma
