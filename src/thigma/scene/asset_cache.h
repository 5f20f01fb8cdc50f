#pragma once
// Levels of detail of any surface a user names: read where they are kept, built and kept where not.

#include <functional>
#include <optional>
#include <string>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/clod_asset.h"
#include "thigma/core/log.h"

namespace thigma {

/// Where levels of detail come from.
struct ClodSource {
  std::string name{};                         // a mesh or .clod file, or procedural:NAME
  std::string role = "MESH";                  // of the name, for messages: "OBJECT", "--object"
  double scale = 1.0;                         // metres per unit of the file
  bool is_repair = false;                     // take repairable meshes repaired
  ClodParams params{};                        // of building; not read of a .clod file
  std::optional<double> contact_tolerance{};  // instead of that of params [m]
  // Null, or called while building with the share that is done and the triangles of the whole.
  std::function<void(double share, double triangles)> progress{};
};

/// Where they are kept.
struct AssetCache {
  bool is_enabled = true;
  // "": beside the mesh, else (and for procedural models) the user's cache folder
  std::string folder;
};

/// The usable surface of a mesh file or model, scaled; repairs are told.
/// Thread [offline]; throws InputError for anything that cannot be used, a .clod file among it.
TriangleMesh load_surface(const ClodSource& source, const Log& log = {});

/// Radius of a surface that can be used [m], without building anything: what is wrong with a second
/// mesh shall not cost the time of building the first.
/// Thread [offline]; throws InputError as load_clod.
double check_source(const ClodSource& source);

/// Reads a .clod file, or builds levels of a mesh or model in memory. Nothing is kept.
///
/// log    may be empty
/// Thread  [offline]; throws InputError for anything that cannot be used.
ClodAsset load_clod(const ClodSource& source, const Log& log = {});

/// The same through a cache. An asset is kept as NAME.<16 digits of the parameters>.clod beside the
/// mesh, or in $XDG_CACHE_HOME/thigma or ~/.cache/thigma where that cannot be written or there is
/// no file. It is used when its key, a digest of the mesh's bytes, all parameters, the format and
/// this build of the program, is the one wanted; a stale or damaged one is built again with a
/// notice. Where nothing can be written nothing is kept, with a notice. Any number of processes and
/// threads may do this at once: files appear whole, under their final name.
///
/// Kept in units of the file and scaled on reading, so that one asset serves every scale.
/// Thread  [offline]; throws as load_clod.
ClodAsset load_clod_cached(const ClodSource& source, const AssetCache& cache = {},
                           const Log& log = {});

/// True for a file that starts as a .clod does. False for what cannot be read.
bool is_clod_file(const std::string& path);

}  // namespace thigma
