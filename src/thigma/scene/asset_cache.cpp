#include "thigma/scene/asset_cache.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "thigma/clod/clod_file.h"
#include "thigma/core/error.h"
#include "thigma/files/checksum.h"
#include "thigma/files/compression.h"
#include "thigma/files/file.h"
#include "thigma/import/load_mesh.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/detail/build_fields.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

// ---- keys
// ------------------------------------------------------------

/// Appends the fields of a list (detail/build_fields.h) by value; doubles to the last bit.
struct KeyWriter {
  std::string& text;

  void operator()(const char* name, double value) const {
    char number[32];
    std::snprintf(number, sizeof number, "%a", value);
    text += std::string(name) + ' ' + number + '\n';
  }
};

std::string params_text(const ClodSource& source) {
  std::string text;
  detail::visit_build_fields(source, KeyWriter{text});
  return text;
}

/// What made an asset: raised whenever the same mesh and parameters give other bytes, which a test
/// of the bytes asks for. Levels kept by a program of another number are built again.
std::string program_text() { return "levels " + std::to_string(kBuildRevision) + "\n"; }

std::string first_digits(const Sha256& digest) { return hex_text(digest).substr(0, 16); }

Sha256 key_of(const Sha256& source, const std::string& params) {
  return sha256(program_text() + hex_text(source) + "\n" + params);
}

// ---- places
// ------------------------------------------------------------

/// Where an asset is kept, "" without a folder.
std::string place_of(const ClodSource& source, const AssetCache& cache, bool is_model,
                     const Sha256& digest) {
  const std::string folder = cache.folder.empty() ? cache_folder() : cache.folder;
  if (folder.empty()) return "";
  const std::string name = is_model ? models::parse_model_uri(source.name, source.role).name
                                    : fs::path(source.name).filename().string();
  // Meshes of one name from many folders meet here.
  return folder + "/" + name + "." + first_digits(sha256(hex_text(digest) + params_text(source))) +
         (has_zstd() ? ".clod.zst" : ".clod");
}

/// The place, or where a program without compression, or an earlier one, kept the same.
std::string found_place(const std::string& place) {
  std::error_code unknown;
  const fs::path path = place;
  if (path.extension() != ".zst" || fs::exists(path, unknown)) return place;
  const std::string plain = (path.parent_path() / path.stem()).string();
  return fs::exists(plain, unknown) ? plain : place;
}

bool is_kept_name(const fs::path& path) {
  return path.extension() == ".clod" ||
         (path.extension() == ".zst" && path.stem().extension() == ".clod");
}

/// What is at a place.
ClodAsset read_kept_file(const std::string& place) {
  constexpr std::uint64_t kMostShrunk = 1000;  // levels shrink to a third; what claims more lies
  const std::string bytes = read_file(place);
  const std::optional<std::uint64_t> size = expanded_size(bytes);
  if (!size) return parse_clod(bytes, place);
  std::optional<std::string> whole =
      *size <= kMostShrunk * bytes.size() ? expand(bytes, *size) : std::nullopt;
  if (!whole) throw InputError(place + ": it is damaged, expected a compressed .clod");
  return parse_clod(*whole, place);
}

void write_kept_file(const std::string& place, const std::string& bytes) {
  constexpr int kLevel = 3;
  const std::string shorter = compress(bytes, kLevel);
  write_file(place, shorter.empty() ? bytes : shorter);
}

void say(const Log& log, const std::string& text) {
  if (log) log(text);
}

/// An asset from its place, or nothing, with a notice when something was there.
bool read_kept(const std::string& wanted, const Sha256& key, const Log& log, ClodAsset& asset) {
  std::error_code unknown;
  const std::string place = found_place(wanted);
  if (place.empty() || !fs::exists(place, unknown)) return false;
  try {
    asset = read_kept_file(place);
    if (asset.origin.key != key) {
      say(log, place + ": of another mesh, other parameters or another version; built again");
      return false;
    }
    fs::last_write_time(place, fs::file_time_type::clock::now(), unknown);  // used: not old
    return true;
  } catch (const InputError& error) {
    say(log, std::string(error.what()) + "; built again");
  }
  return false;
}

/// Keeps an asset at its place.
void keep(const std::string& place, const ClodAsset& asset, const std::string& name,
          const Log& log) {
  std::string why = "no folder to write to";
  try {
    if (place.empty()) throw IoError(why);
    std::error_code ignored;  // a folder that cannot be made cannot be written to either
    fs::create_directories(fs::path(place).parent_path(), ignored);
    write_kept_file(place, format_clod(asset, name));
    return say(log, name + ": levels of detail kept in " + place);
  } catch (const IoError& error) {
    why = error.what();
  }
  say(log, name + ": levels of detail are not kept: " + why);
}

// ---- building
// ------------------------------------------------------------

TriangleMesh load_scaled(const ClodSource& source, double scale, bool is_model,
                         std::vector<std::string>& repairs) {
  if (!is_model) return load_usable_mesh(source.name, scale, source.is_repair, nullptr, &repairs);
  TriangleMesh mesh = models::make_model(models::parse_model_uri(source.name, source.role));
  scale_mesh(mesh, scale, source.name);
  return mesh;
}

ClodAsset build_from(const ClodSource& source, double scale, bool is_model, const Log& log,
                     ClodReport& report) {
  std::vector<std::string> repairs;
  const TriangleMesh mesh = load_scaled(source, scale, is_model, repairs);
  for (const std::string& repair : repairs) say(log, source.name + ": repaired: " + repair);
  ClodParams params = source.params;
  if (source.contact_tolerance)
    params.contact_tolerance =
        *source.contact_tolerance * scale / source.scale / enclosing_ball(mesh.positions).radius;
  if (source.progress) {
    const auto triangles = static_cast<double>(mesh.triangles.size());
    params.simplify.progress = [&source, triangles](double share) {
      source.progress(share, triangles);
    };
    source.progress(0.0, triangles);
  }
  ClodAsset asset = build_clod_asset(mesh, params, &report);
  asset.origin.unit_scale = scale;
  asset.origin.is_repaired = !repairs.empty();
  return asset;
}

std::string built_text(const ClodAsset& asset, const ClodReport& report) {
  const ClodHierarchy& h = asset.hierarchy;
  const double seconds = report.decompose_seconds + report.simplify_seconds + report.tree_seconds +
                         report.parameter_seconds;
  char text[160];
  std::snprintf(text, sizeof text,
                "%d triangles, %zu convex patches, %zu levels built in %.1f s of CPU time",
                h.triangle_count, h.patches.size(), h.levels.size(), seconds);
  return text;
}

/// Of the text that fully names a model, or of a file's bytes.
Sha256 digest_of(const ClodSource& source, bool is_model) {
  if (!is_model) return sha256(read_file(source.name));
  const models::ModelRequest request = models::parse_model_uri(source.name, source.role);
  return sha256("procedural:" + request.name + "?triangles=" + std::to_string(request.triangles) +
                "&seed=" + std::to_string(request.seed));
}

}  // namespace

std::string cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && cache[0] == '/') return std::string(cache) + "/thigma";
  const char* home = std::getenv("HOME");
  return home != nullptr && home[0] == '/' ? std::string(home) + "/.cache/thigma" : "";
}

std::vector<KeptAsset> list_cache(const std::string& folder) {
  std::vector<KeptAsset> found;
  std::error_code none;
  const auto now = fs::file_time_type::clock::now();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    std::error_code gone;  // by another process
    if (!is_kept_name(entry.path()) || !entry.is_regular_file(gone)) continue;
    const std::uintmax_t bytes = entry.file_size(gone);
    const auto used = entry.last_write_time(gone);
    if (gone) continue;
    found.push_back(
        {entry.path().string(), bytes, std::chrono::duration<double>(now - used).count()});
  }
  std::sort(found.begin(), found.end(),
            [](const KeptAsset& a, const KeptAsset& b) { return a.path < b.path; });
  return found;
}

std::vector<KeptAsset> clear_cache(const std::string& folder, double least_age) {
  std::vector<KeptAsset> removed;
  for (const KeptAsset& kept : list_cache(folder)) {
    if (kept.age < least_age) continue;
    std::error_code failed;
    if (fs::remove(kept.path, failed)) removed.push_back(kept);
    if (failed) throw IoError(kept.path + ": cannot be removed (" + failed.message() + ")");
  }
  return removed;
}

bool is_clod_file(const std::string& path) {
  std::error_code unknown;
  if (!fs::is_regular_file(path, unknown)) return false;  // a pipe would lose what is read of it
  char start[8] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(start, sizeof start);
  return is_clod({start, static_cast<std::size_t>(file.gcount())});
}

TriangleMesh load_surface(const ClodSource& source, const Log& log) {
  std::vector<std::string> repairs;
  TriangleMesh mesh = load_scaled(source, source.scale, models::is_model_uri(source.name), repairs);
  for (const std::string& repair : repairs) say(log, source.name + ": repaired: " + repair);
  return mesh;
}

double check_source(const ClodSource& source) {
  const bool is_model = models::is_model_uri(source.name);
  if (is_model) {  // of a known size; making one takes time
    models::parse_model_uri(source.name, source.role);
    return 0.0;
  }
  if (is_clod_file(source.name)) return read_clod(source.name, source.scale).hierarchy.radius;
  return enclosing_ball(load_surface(source).positions).radius;
}

ClodAsset load_clod(const ClodSource& source, const Log& log) {
  const bool is_model = models::is_model_uri(source.name);
  if (!is_model && is_clod_file(source.name)) return read_clod(source.name, source.scale);
  ClodReport report;
  ClodAsset asset = build_from(source, source.scale, is_model, log, report);
  std::error_code unknown;
  if (is_model || fs::is_regular_file(source.name, unknown))
    asset.origin.source = digest_of(source, is_model);
  return asset;
}

namespace {

/// Whether what is built of a source is kept.
bool is_cached(const ClodSource& source, const AssetCache& cache, bool is_model) {
  std::error_code unknown;
  return cache.is_enabled &&
         (is_model || (fs::is_regular_file(source.name, unknown) && !is_clod_file(source.name)));
}

}  // namespace

std::optional<ClodAsset> find_clod_cached(const ClodSource& source, const AssetCache& cache,
                                          const Log& log) {
  const bool is_model = models::is_model_uri(source.name);
  if (!is_cached(source, cache, is_model)) return std::nullopt;
  const Sha256 digest = digest_of(source, is_model);
  const std::string place = place_of(source, cache, is_model, digest);
  ClodAsset asset;
  if (!read_kept(place, key_of(digest, params_text(source)), log, asset)) return std::nullopt;
  scale_clod(asset, source.scale, source.name);
  return asset;
}

ClodAsset load_clod_cached(const ClodSource& source, const AssetCache& cache, const Log& log) {
  const bool is_model = models::is_model_uri(source.name);
  if (!is_cached(source, cache, is_model)) return load_clod(source, log);
  const Sha256 digest = digest_of(source, is_model);
  const Sha256 key = key_of(digest, params_text(source));
  const std::string place = place_of(source, cache, is_model, digest);
  ClodAsset asset;
  if (!read_kept(place, key, log, asset)) {
    ClodReport report;
    asset = build_from(source, 1.0, is_model, log, report);
    say(log, source.name + ": " + built_text(asset, report));
    asset.origin.source = digest;
    asset.origin.key = key;
    // A mesh that changed in the meantime would be kept under the digest of what it was.
    if (digest_of(source, is_model) == digest) keep(place, asset, source.name, log);
  }
  scale_clod(asset, source.scale, source.name);
  return asset;
}

}  // namespace thigma
