#pragma once
// A scene of several bodies that move ([[body]]), and what a session of it needs.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/scene/load_scene.h"
#include "thigma/scene/scene_description.h"
#include "thigma/session/world_session.h"

namespace thigma {

inline constexpr std::size_t kMostBodies = 1000;  // of a world, as a file gives it or later

/// A body as a scene describes it: [object] is held, [[static]] fixed, [[body]] moves.
struct WorldSceneBody {
  SceneObject object;
  BodyKind kind = BodyKind::moving;
  std::optional<double> mass, density;                // one of them, of what moves
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();  // at the start; of a prescribed body always
};

/// A device of a scene and what it holds.
struct WorldSceneDevice {
  std::string uri = "hand:";
  std::string holds;               // name of a body; "": [object]
  std::optional<Vec3> at;          // where it takes hold [m; world]; else the body's centre
  Vec3 approach = -Vec3::UnitZ();  // of a simulated hand [world]
  double clearance = 0.02;         // on its way to the first touch [m]
  Workspace workspace;             // how its axes lie in the world, and its scales
  SafetyLimits limits;             // of [safety], and its own where they are named
};

/// A joint as a scene describes it, where its bodies stand at the start.
struct WorldSceneJoint {
  std::string name;
  JointKind kind = JointKind::ball;
  std::string body, to;             // names; "" of the second: the world
  Vec3 position = Vec3::Zero();     // [m; world]
  std::optional<Vec3> to_position;  // of a spring: its place on the other body
  Vec3 axis = Vec3::UnitZ();        // of any length above 0 [world]
  std::optional<double> lower, upper, rest;
  double stiffness = 0.0, damping = 0.0;
  JointMotor motor;
  bool touches = false;
};

/// A world, as a file gives it.
struct WorldSceneDescription {
  std::string file, title;
  std::string text;                          // that it was read from
  std::map<std::string, std::string> files;  // meshes: as the text names them, where they are
  Vec3 gravity = Vec3::Zero();               // [m/s^2]
  std::vector<WorldSceneBody> bodies;
  std::vector<WorldSceneJoint> joints;
  CouplingGains coupling;
  std::vector<WorldSceneDevice> devices;  // one of [object] where none is named
  SafetyLimits safety;                    // of devices that name no others
  double rate = 1000.0;                   // of steps [Hz]
  bool sleeps = true;
  double threshold = 0.0;  // s0 of levels of detail far away, as of World; 0: all is exact
};

/// Whether a scene file has bodies that move. False for what cannot be read.
/// Thread [offline].
bool is_world_scene(const std::string& path);

/// Reads a scene with [[body]] (docs/formats.md); built-in ones by name.
///
/// errors  InputError "FILE: what, line N, what was expected"
/// Thread  [offline]
WorldSceneDescription read_world_scene(const std::string& path);

/// The same from text. file and folder as of parse_scene.
WorldSceneDescription parse_world_scene(std::string_view text, const std::string& file,
                                        const std::string& folder);

/// A world with its surfaces. May be moved.
struct LoadedWorld {
  WorldSceneDescription description;
  std::vector<std::shared_ptr<const ClodHierarchy>> hierarchies;  // one a body; equal ones shared
  std::vector<std::shared_ptr<const TriangleMesh>> meshes;        // likewise
  WorldSessionConfig config;                                      // without a device
};

/// Loads its meshes, and refuses bodies that start in each other.
///
/// errors  InputError by the body's name: a mesh, mass or density that cannot be used, a start
///         inside another body; by the joint's: an unknown body, and what check_joint refuses
/// Thread  [offline]
LoadedWorld load_world(WorldSceneDescription description, const Log& log = {});

/// The devices of a world, one a hand of its config.
struct WorldDevices {
  std::vector<std::unique_ptr<HapticDevice>> owned;
  std::vector<HapticDevice*> list;
};

/// A hand that holds nothing until it is aimed at a body that moves (WorldRun::aim); couplings as
/// the scene has them for each body.
/// Thread  [offline]
WorldHand free_hand(const LoadedWorld& world);

/// Hands whose device is that of a person hold by its clutch: of all but simulated ones, which have
/// always hold of their bodies. Before a session, and before it is replayed.
///
/// uris    as of open_world_devices
/// Thread  [offline]
void use_clutches(const std::vector<std::string>& uris, LoadedWorld& world);

/// Opens them. Free hands get null.
///
/// uris          by hand; those left out or empty are the scene's
/// seed          of the first; each further one has the next
/// has_watchdog  by the clock, where haptic steps are apart from the world's. Else every device but
///               simulated ones is refused, by its address, before anything is opened
/// errors        DeviceAddressError, DeviceUnavailable
/// Thread        [offline]
WorldDevices open_world_devices(const LoadedWorld& world, const std::vector<std::string>& uris,
                                std::uint64_t seed, bool has_watchdog = false);

}  // namespace thigma
