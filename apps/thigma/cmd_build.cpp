// thigma build MESH -o F: contact levels of detail into a .clod file.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <thread>

#include "json_out.h"
#include "number_text.h"
#include "progress.h"
#include "verbs.h"
#include <sys/resource.h>
#include <unistd.h>

#include "thigma/clod/clod_file.h"
#include "thigma/core/cpu_clock.h"
#include "thigma/core/error.h"
#include "thigma/files/checksum.h"
#include "thigma/files/file.h"
#include "thigma/import/read_mesh.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/asset_cache.h"

namespace thigma::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int kMostThreads = 256;

struct BuildOptions {
  std::string mesh, out;
  double scale = 1.0;
  int threads = 0;  // 0: as many as there are
  bool repair = false;
  std::optional<double> contact_tolerance;  // [m]
};

/// What a user gets to know of a build besides the asset.
struct BuildFigures {
  double seconds = 0.0;  // of wall time
  std::size_t file_bytes = 0;
  std::string sha256;
};

std::string what_is_wrong(const BuildOptions& options) {
  if (!(options.scale > 0.0) || !std::isfinite(options.scale))
    return "--scale must be a finite number above 0";
  if (options.threads < 0 || options.threads > kMostThreads)
    return "--threads must be a whole number of 1 to 256";
  if (options.contact_tolerance &&
      !(*options.contact_tolerance > 0.0 && std::isfinite(*options.contact_tolerance)))
    return "--contact-tolerance must be a finite length above 0 [m]";
  std::error_code unknown;
  if (fs::equivalent(options.mesh, options.out, unknown))
    return "-o is the mesh itself, expected another file";
  return "";
}

/// Better now than after a minute of work.
void refuse_closed_place(const std::string& out) {
  std::error_code unknown;
  const fs::path folder = fs::path(out).parent_path();
  const bool is_device = fs::exists(out, unknown) && !fs::is_regular_file(out, unknown);
  const std::string place = is_device ? out : folder.empty() ? "." : folder.string();
  if (!fs::is_directory(out, unknown) && ::access(place.c_str(), W_OK) == 0) return;
  throw IoError(out + ": cannot be written: a folder itself, or in none that takes it");
}

/// Share of the volume a level lost, null of an open surface and of a free level.
ordered_json volume_lost(const ClodAsset& asset, std::size_t level) {
  if (!asset.mass.is_closed || level >= asset.meshes.size()) return nullptr;
  const double lost = 1.0 - mass_properties(asset.meshes[level]).volume / asset.mass.measure.volume;
  return std::isfinite(lost) ? ordered_json(lost) : ordered_json(nullptr);
}

ordered_json level_json(const ClodAsset& asset, std::size_t k) {
  const ClodHierarchy& h = asset.hierarchy;
  const ClodLevel& level = h.levels[k];
  const bool is_simplified = k > 0 && !level.is_free;
  const auto of_mesh = [&](const auto& value) {
    return level.is_free ? ordered_json(nullptr) : ordered_json(value);
  };
  ordered_json j;
  j["level"] = k;
  j["free"] = level.is_free;
  j["triangles"] = of_mesh(k == 0 ? h.triangle_count : level.triangle_count);
  j["patches"] = level.is_free ? level.node_count
                 : k == 0      ? static_cast<std::int32_t>(h.patches.size())
                               : level.patch_count;
  j["resolution"] = is_simplified ? ordered_json(level.resolution) : ordered_json(nullptr);
  j["deviation_max"] = of_mesh(level.deviation_max);
  j["hausdorff_max"] = is_simplified ? level.contact_hausdorff_max : level.hausdorff_max;
  j["nodes"] = level.node_count;
  j["volume_lost"] = volume_lost(asset, k);
  return j;
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

ordered_json report_json(const BuildOptions& options, const ClodAsset& asset,
                         const BuildFigures& figures) {
  ordered_json j;
  j["file"] = options.out;
  j["triangles"] = asset.hierarchy.triangle_count;
  j["patches"] = asset.hierarchy.patches.size();
  j["radius"] = asset.hierarchy.radius;
  j["levels"] = ordered_json::array();
  for (std::size_t k = 0; k < asset.hierarchy.levels.size(); ++k)
    j["levels"].push_back(level_json(asset, k));
  j["seconds"] = figures.seconds;
  j["cpu_seconds"] = process_cpu_seconds();
  j["peak_bytes"] = static_cast<std::int64_t>(peak_bytes());
  j["file_bytes"] = figures.file_bytes;
  j["sha256"] = figures.sha256;
  return j;
}

/// The columns of Table 3.2: r of the object scaled to a radius of 1.
std::string report_text(const BuildOptions& options, const ClodAsset& asset,
                        const BuildFigures& figures) {
  const ClodHierarchy& h = asset.hierarchy;
  std::ostringstream out;
  char line[160];
  out << options.out << ": " << h.triangle_count << " triangles, " << h.patches.size()
      << " convex patches, radius " << with_unit(h.radius, "m") << '\n';
  std::snprintf(line, sizeof line, "  %5s %9s %9s %12s %12s %12s\n", "level", "triangles",
                "patches", "r x radius", "s / radius", "h / radius");
  out << line;
  for (std::size_t k = 0; k < h.levels.size(); ++k) {
    const ClodLevel& l = h.levels[k];
    if (l.is_free)
      std::snprintf(line, sizeof line, "  %5zu %9s %9d %12s %12s %12.2e\n", k, "free", l.node_count,
                    "", "", l.hausdorff_max / h.radius);
    else if (k == 0)
      std::snprintf(line, sizeof line, "  %5zu %9d %9zu\n", k, h.triangle_count, h.patches.size());
    else
      std::snprintf(line, sizeof line, "  %5zu %9d %9d %12.2f %12.2e %12.2e\n", k, l.triangle_count,
                    l.patch_count, l.resolution * h.radius, l.deviation_max / h.radius,
                    l.contact_hausdorff_max / h.radius);
    out << line;
  }
  std::snprintf(line, sizeof line,
                "  %.1f s (%.1f s of CPU), %.0f MiB at most, %.1f MiB written, sha256 ",
                figures.seconds, process_cpu_seconds(), peak_bytes() / 1048576.0,
                static_cast<double>(figures.file_bytes) / 1048576.0);
  out << line << figures.sha256 << '\n';
  return out.str();
}

ClodAsset build_asset(const BuildOptions& options, const Common& common) {
  ClodSource source{.name = options.mesh, .scale = options.scale, .is_repair = options.repair};
  const auto hardware = static_cast<int>(std::thread::hardware_concurrency());
  source.params.threads =
      options.threads > 0 ? options.threads : std::clamp(hardware, 1, kMostThreads);
  source.contact_tolerance = options.contact_tolerance;
  Progress progress("building " + options.mesh, "triangles", !common.quiet);
  source.progress = [&](double share, double triangles) { progress.update(share, triangles); };
  const Log log = common.quiet ? Log{} : [](const std::string& text) {
    std::cerr << "thigma: " << text << "\n";
  };
  return load_clod(source, log);
}

int build(const Common& common, const BuildOptions& options) {
  if (const std::string wrong = what_is_wrong(options); !wrong.empty()) {
    print_error("build: " + wrong);
    return kUsage;
  }
  if (is_clod_file(options.mesh))
    throw InputError(options.mesh + ": is levels of detail already, byte 0, expected a mesh: " +
                     mesh_kind_names());
  refuse_closed_place(options.out);
  const auto start = std::chrono::steady_clock::now();
  const ClodAsset asset = build_asset(options, common);
  const std::string bytes = format_clod(asset, options.mesh);
  write_file(options.out, bytes);
  BuildFigures figures;
  figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  figures.file_bytes = bytes.size();
  figures.sha256 = hex_text(sha256(bytes));
  if (common.json)
    print_json(report_json(options, asset, figures));
  else
    std::cout << report_text(options, asset, figures) << std::flush;
  return kDone;
}

}  // namespace

void add_build(CLI::App& app, Common& common) {
  const auto options = std::make_shared<BuildOptions>();
  CLI::App* verb = add_verb(app, common, "build", "build contact levels of detail of a mesh",
                            [&common, options] { return build(common, *options); });
  verb->add_option("MESH", options->mesh,
                   mesh_kind_names() + ", recognised by content, or procedural:NAME")
      ->required();
  verb->add_option("-o,--output", options->out, ".clod file to write")->required();
  verb->add_option("--scale", options->scale, "metres per unit of the mesh");
  verb->add_option("--threads", options->threads,
                   "as many as there are by default; the file is the same with any")
      ->check(CLI::Range(1, kMostThreads));
  verb->add_flag("--repair", options->repair, "take a repairable mesh and repair it");
  verb->add_option(
      "--contact-tolerance", options->contact_tolerance,
      "tolerance of the queries to come, for support areas [m]; 0.4 % of the radius by default");
}

}  // namespace thigma::app
