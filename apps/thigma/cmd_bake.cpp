// thigma bake: haptic textures into .tex files.

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "clod_cache.h"
#include "height_file.h"
#include "json_out.h"
#include "progress.h"
#include "scenes/make_model.h"
#include "verbs.h"

#include "thigma/clod/clod_file.h"
#include "thigma/core/checksum.h"
#include "thigma/core/error.h"
#include "thigma/core/file.h"
#include "thigma/mesh/load_mesh.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/read_texture_coordinates.h"
#include "thigma/texture/bake.h"
#include "thigma/texture/level_textures.h"

namespace thigma::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct BakeOptions {
  std::string mesh;    // the fine surface, or with a height map the coarse one
  std::string onto;    // the coarse surface
  std::string height;  // or a height map
  std::string out;
  double amplitude = 0.0;  // [m]
  double scale = 1.0;
  int texels = 1024;
  std::optional<int> level;  // of levels of detail to bake onto
  bool repair = false;
};

std::string what_is_wrong(const BakeOptions& options) {
  const bool is_height = !options.height.empty();
  if (is_height == !options.onto.empty()) return "needs either --onto or --height";
  if (is_height && !(options.amplitude > 0.0 && std::isfinite(options.amplitude)))
    return "--height needs --amplitude, a finite length above 0 [m]";
  if (!is_height && options.amplitude != 0.0) return "--amplitude goes with --height";
  if (options.level && !is_clod_file(options.onto)) return "--level goes with --onto a .clod file";
  if (!(options.scale > 0.0) || !std::isfinite(options.scale))
    return "--scale must be a finite number above 0";
  std::error_code unknown;
  for (const std::string* in : {&options.mesh, &options.onto, &options.height})
    if (!in->empty() && fs::equivalent(*in, options.out, unknown))
      return "-o is " + *in + " itself, expected another file";
  return "";
}

/// The surfaces of the levels of a .clod file.
std::vector<TriangleMesh> level_surfaces(const BakeOptions& options) {
  ClodAsset asset = read_clod(options.onto, options.scale);
  if (asset.meshes.empty())
    throw InputError(options.onto + ": no surfaces of its levels, in its table, expected them");
  return std::move(asset.meshes);
}

TriangleMesh level_surface(const BakeOptions& options, int level) {
  std::vector<TriangleMesh> meshes = level_surfaces(options);
  const int coarsest = static_cast<int>(meshes.size()) - 1;
  if (level > coarsest)
    throw InputError(options.onto + ": no level " + std::to_string(level) +
                     " with a surface, in its table, expected at most " + std::to_string(coarsest));
  return std::move(meshes[static_cast<std::size_t>(level)]);
}

TriangleMesh load(const Common& common, const BakeOptions& options, const std::string& name, const char* role) {
  const Tell tell = common.quiet ? Tell{} : [](const std::string& text) {
    std::cerr << "thigma: " << text << "\n";
  };
  return load_surface({.name = name, .role = role, .scale = options.scale, .is_repair = options.repair}, tell);
}

BakeParams params_of(const Common& common, const BakeOptions& options) {
  return {.texels = options.texels, .seed = common.seed};
}

TextureAsset bake_onto(const Common& common, const BakeOptions& options) {
  const TriangleMesh fine = load(common, options, options.mesh, "FINE");
  const TriangleMesh coarse =
      options.level ? level_surface(options, *options.level) : load(common, options, options.onto, "--onto");
  return bake_surface(fine, coarse, params_of(common, options), options.mesh);
}

LevelTextures bake_onto_levels(const Common& common, const BakeOptions& options) {
  const TriangleMesh fine = load(common, options, options.mesh, "FINE");
  const std::vector<TriangleMesh> levels = level_surfaces(options);
  Progress bar("baking onto " + options.onto, "levels", !common.quiet);
  return {bake_levels(fine, levels, params_of(common, options), options.mesh,
                      [&](double share) { bar.update(share, share * static_cast<double>(levels.size())); })};
}

TextureAsset bake_map(const BakeOptions& options) {
  const HeightImage image = read_height_file(options.height);
  if (scenes::is_model_uri(options.mesh) || is_clod_file(options.mesh))
    throw InputError(options.mesh +
                     ": no texture coordinates, in it as a whole, expected an OBJ with vt");
  TriangleMesh coarse = load_usable_mesh(options.mesh, options.scale);
  return bake_heights(std::move(coarse),
                      read_texture_coordinates(read_file(options.mesh), options.mesh), image,
                      options.amplitude, options.mesh);
}

ordered_json number(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json texture_json(const TextureAsset& asset) {
  const HapticTexture& t = asset.texture;
  const BakeFigures& f = asset.figures;
  ordered_json j;
  j["texels"] = std::max(t.width, t.height);
  j["width"] = t.width;
  j["height"] = t.height;
  j["charts"] = f.charts;
  j["fit_error_rms"] = number(f.fit_error_rms);
  j["fit_error_max"] = number(f.fit_error_max);
  j["crack_max"] = number(f.crack_max);
  j["distortion_max"] = f.distortion_max;
  j["texel_size"] = t.texel_size;
  j["amplitude"] = t.amplitude;
  j["radius"] = enclosing_ball(t.coarse.positions).radius;
  j["triangles"] = t.coarse.triangles.size();
  return j;
}

/// What all levels have together, worst of each, and each of them.
ordered_json levels_json(const LevelTextures& textures) {
  ordered_json j, levels = ordered_json::array();
  for (std::size_t k = 0; k < textures.levels.size(); ++k) {
    if (!textures.levels[k]) continue;
    ordered_json level = texture_json(*textures.levels[k]);
    if (levels.empty()) j = level;
    for (const char* key : {"fit_error_rms", "fit_error_max", "crack_max", "distortion_max", "texel_size", "amplitude"})
      if (level[key] > j[key]) j[key] = level[key];
    ordered_json named;
    named["level"] = k;
    named.update(level);
    levels.push_back(std::move(named));
  }
  j["levels"] = std::move(levels);
  return j;
}

std::string texture_text(const ordered_json& j, double radius) {
  std::ostringstream out;
  out << j["width"] << " x " << j["height"] << " texels of " << j["texel_size"].get<double>() << " m in "
      << j["charts"] << " charts over " << j["triangles"] << " triangles\n  relief +-"
      << j["amplitude"].get<double>() << " m, distortion at most " << j["distortion_max"].get<double>() << "\n";
  if (!j["fit_error_rms"].is_null())
    out << "  fit error " << j["fit_error_rms"].get<double>() << " m RMS ("
        << 100.0 * j["fit_error_rms"].get<double>() / radius << " % of the radius), "
        << j["fit_error_max"].get<double>() << " m at most ("
        << 100.0 * j["fit_error_max"].get<double>() / radius << " %), cracks at seams "
        << j["crack_max"].get<double>() << " m\n";
  return out.str();
}

std::string report_text(const ordered_json& j) {
  const double radius = j["radius"].get<double>();
  std::ostringstream out;
  out << j["file"].get<std::string>() << ": radius " << radius << " m\n";
  if (!j.contains("levels")) return out.str() + texture_text(j, radius);
  for (const ordered_json& level : j["levels"])
    out << "level " << level["level"] << ": " << texture_text(level, radius);
  return out.str();
}

int bake(const Common& common, const BakeOptions& options) {
  if (const std::string wrong = what_is_wrong(options); !wrong.empty()) {
    tell_error("bake: " + wrong);
    return kUsage;
  }
  const auto start = std::chrono::steady_clock::now();
  ordered_json report;
  std::string bytes;
  if (options.height.empty() && is_clod_file(options.onto) && !options.level) {
    const LevelTextures textures = bake_onto_levels(common, options);
    if (textures.levels.size() == 1 && !textures.levels[0])
      throw InputError(options.onto + ": no simplified levels, in its table, expected some to bake onto");
    bytes = format_level_textures(textures);
    report = levels_json(textures);
  } else {
    const TextureAsset asset = options.height.empty() ? bake_onto(common, options) : bake_map(options);
    bytes = format_texture(asset);
    report = texture_json(asset);
  }
  write_file(options.out, bytes);
  ordered_json json;
  json["file"] = options.out;
  json.update(report);
  json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  json["file_bytes"] = bytes.size();
  json["sha256"] = hex_text(sha256(bytes));
  if (common.json)
    print_json(json);
  else
    std::cout << report_text(json) << std::flush;
  return kDone;
}

}  // namespace

void add_bake(CLI::App& app, Common& common) {
  const auto options = std::make_shared<BakeOptions>();
  CLI::App* verb = add_verb(app, common, "bake", "Bake a haptic texture",
                            [&common, options] { return bake(common, *options); });
  verb->add_option("MESH", options->mesh,
                   "the fine surface, or with --height the coarse one, an OBJ with vt")
      ->required();
  verb->add_option("--onto", options->onto,
                   "coarse surface: a mesh, procedural:NAME or a .clod file");
  verb->add_option("--level", options->level,
                   "of a .clod file: onto this one alone, as a plain surface; all of them by default")
      ->check(CLI::Range(0, 1000));
  verb->add_option("--height", options->height, "height map: PGM or grey PNG, 8 or 16 bits");
  verb->add_option("--amplitude", options->amplitude,
                   "white lies this far outside, black inside [m]");
  verb->add_option("-o,--output", options->out, ".tex file to write")->required();
  verb->add_option("--texels", options->texels, "along each side of the map; with --onto only")
      ->check(CLI::Range(16, kMaxTextureSide / 2));
  verb->add_option("--scale", options->scale, "metres per unit of the meshes");
  verb->add_flag("--repair", options->repair, "take repairable meshes and repair them");
}

}  // namespace thigma::app
