#pragma once
// Levels of detail of any surface a user names: read where they are kept, built and kept where not.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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
  std::string folder;  // "": cache_folder()
};

/// Raised whenever the same mesh and parameters are built to other bytes: levels that were kept
/// before are built again.
inline constexpr int kBuildRevision = 1;

/// The user's cache folder: $XDG_CACHE_HOME/thigma, or ~/.cache/thigma; "" without either.
/// Thread [offline].
std::string cache_folder();

/// An asset in the cache.
struct KeptAsset {
  std::string path;
  std::uint64_t bytes = 0;
  double age = 0.0;  // since it was used last [s]
};

/// The assets that a cache folder holds, by path; none of a folder that is not there.
/// Thread [offline].
std::vector<KeptAsset> list_cache(const std::string& folder);

/// Removes those that have not been used for so long; returns them.
///
/// least_age  0: all [s]
/// errors     IoError for one that cannot be removed
/// Thread     [offline]
std::vector<KeptAsset> clear_cache(const std::string& folder, double least_age = 0.0);

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

/// The same through a cache. An asset is kept as NAME.<16 digits of mesh and parameters>.clod in
/// the user's cache folder. It is used when its key, a digest of the mesh's bytes, all parameters,
/// the format and kBuildRevision, is the one wanted; a stale or damaged one is built again with a
/// notice. Where nothing can be written nothing is kept, with a notice. Any number of processes and
/// threads may do this at once: files appear whole, under their final name.
///
/// Kept in units of the file and scaled on reading, so that one asset serves every scale.
/// Thread  [offline]; throws as load_clod.
ClodAsset load_clod_cached(const ClodSource& source, const AssetCache& cache = {},
                           const Log& log = {});

/// The asset that load_clod_cached would find kept, scaled; nothing where it would have to build.
/// Thread  [offline]; throws InputError for a mesh that cannot be read.
std::optional<ClodAsset> find_clod_cached(const ClodSource& source, const AssetCache& cache = {},
                                          const Log& log = {});

/// True for a file that starts as a .clod does. False for what cannot be read.
bool is_clod_file(const std::string& path);

}  // namespace thigma
