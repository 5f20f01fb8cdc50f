#pragma once
// What a page may open in place of the scene that runs: scenes, recordings, meshes dropped on it.

#include <cstdint>
#include <string>
#include <vector>

#include "viewer/server/messages.h"

#include "thigma/import/inspect.h"
#include "thigma/scene/scene_description.h"

namespace thigma::app {

/// Scenes of the program and those the user has saved; the recordings in the folder it runs in and
/// in the user's own.
/// Thread [offline].
live::OpenMenu open_menu();

/// The mesh that a page has sent last, in a folder that goes with this.
/// Thread: one.
class DroppedMesh {
 public:
  DroppedMesh() = default;
  ~DroppedMesh();
  DroppedMesh(const DroppedMesh&) = delete;
  DroppedMesh& operator=(const DroppedMesh&) = delete;

  /// Keeps a file's bytes under (nearly) its name and looks at them: a mesh, or a haptic texture
  /// (.tex), whose coarse surface is looked at. Those before stay until tidy(), as a session or a
  /// scene that is being made may stand on them.
  /// Throws IoError, and InputError for what is neither, of which nothing is kept.
  const MeshReport& keep(const std::string& name, const std::string& bytes);
  /// Keeps a recording in place of the one before, which nothing reads any more then.
  /// returns its path; throws IoError
  std::string keep_recording(const std::string& name, const std::string& bytes);
  /// Removes what was kept, but for the last few and what the scene that runs is made of.
  void tidy(const SceneDescription& now);
  bool is_there() const { return !path_.empty(); }
  const std::string& path() const { return path_; }
  const std::string& name() const { return name_; }
  const MeshReport& report() const { return report_; }
  int number() const { return count_; }  // of the last, by which compositions name it
  /// Path of the file of that number; "" where it is not there (any more).
  std::string path_of(int number) const;

 private:
  std::string new_place();  // a folder for one file; throws IoError

  std::string folder_, path_, name_, recording_;
  MeshReport report_;
  std::vector<std::string> kept_;  // paths, the last included
  int count_ = 0;
};

/// `model`: what the program thinks of a mesh, and what one unit of it might be.
/// radius  of the object in the hand now, which a likely unit makes it most like [m]
std::string model_message(std::int64_t id, const DroppedMesh& mesh, double radius);

/// A scene of a dropped mesh and one that is there: the dropped one in the hand, or standing still;
/// the held one a little above the other. Rate, device and safety limits stay; all else follows
/// from their sizes.
///
/// now     scene that runs
/// unit    metres per unit of the dropped mesh, > 0
/// other   bounds of the surface that stays: of the first static body if is_held, else of the
///         object [m; its mesh frame]
/// Thread  [offline]; InputError where there is no static body to hold it against.
SceneDescription scene_with(const SceneDescription& now, const DroppedMesh& mesh, bool is_held,
                            double unit, const Bounds& other);

}  // namespace thigma::app
