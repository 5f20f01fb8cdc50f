// thigma bake: haptic textures into .tex files.

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "height_file.h"
#include "json_out.h"
#include "progress.h"
#include "verbs.h"

#include "thigma/clod/clod_file.h"
#include "thigma/core/error.h"
#include "thigma/files/checksum.h"
#include "thigma/files/file.h"
#include "thigma/import/load_mesh.h"
#include "thigma/import/read_texture_coordinates.h"
#include "thigma/mesh/measure.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/asset_cache.h"
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
  double amplitude = 0.0;            // [m]
  std::optional<double> scale;       // metres per unit of MESH
  std::optional<double> onto_scale;  // and of the coarse surface
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
  const auto is_scale = [](double scale) { return scale > 0.0 && std::isfinite(scale); };
  if (!is_scale(options.scale.value_or(1.0))) return "--scale must be a finite number above 0";
  if (!is_scale(options.onto_scale.value_or(1.0)))
    return "--onto-scale must be a finite number above 0";
  if (is_height && options.onto_scale) return "--onto-scale goes with --onto";
  std::error_code unknown;
  for (const std::string* in : {&options.mesh, &options.onto, &options.height})
    if (!in->empty() && fs::equivalent(*in, options.out, unknown))
      return "-o is " + *in + " itself, expected another file";
  return "";
}

// Surfaces of one object differ by their relief, and by a cut of a scan; units differ by more.
constexpr double kMostSizeRatio = 4.0;

/// Surfaces to bake onto: a mesh alone, or those of the levels of a .clod file.
struct Onto {
  std::vector<TriangleMesh> surfaces;  // [m]
  double fine_scale = 1.0;             // metres per unit of the fine mesh, where none is named
};

/// A .clod is in metres from its build on, and tells how many a unit of its mesh had: so has the
/// fine mesh. Meshes are of the same unit.
Onto load_onto_clod(const BakeOptions& options) {
  ClodAsset asset = read_clod(options.onto, options.onto_scale.value_or(1.0));
  if (asset.meshes.empty())
    throw InputError(options.onto + ": no surfaces of its levels, in its table, expected them");
  return {std::move(asset.meshes), asset.origin.unit_scale * options.onto_scale.value_or(1.0)};
}

TriangleMesh level_surface(const BakeOptions& options, std::vector<TriangleMesh> meshes,
                           int level) {
  const int coarsest = static_cast<int>(meshes.size()) - 1;
  if (level > coarsest)
    throw InputError(options.onto + ": no level " + std::to_string(level) +
                     " with a surface, in its table, expected at most " + std::to_string(coarsest));
  return std::move(meshes[static_cast<std::size_t>(level)]);
}

TriangleMesh load(const Common& common, const BakeOptions& options, const std::string& name,
                  const char* role, double scale) {
  const Log log = common.quiet ? Log{} : [](const std::string& text) {
    std::cerr << "thigma: " << text << "\n";
  };
  return load_surface({.name = name, .role = role, .scale = scale, .is_repair = options.repair},
                      log);
}

/// A unit forgotten ends in nothing found near anything, after minutes.
void refuse_other_sizes(const BakeOptions& options, const TriangleMesh& fine, double fine_scale,
                        const TriangleMesh& coarse) {
  const double radius = enclosing_ball(fine.positions).radius;
  const double wanted = enclosing_ball(coarse.positions).radius;
  if (radius <= kMostSizeRatio * wanted && wanted <= kMostSizeRatio * radius) return;
  char line[160];
  std::snprintf(line, sizeof line,
                ": a radius of %.3g m, in the mesh as a whole, expected about the %.3g m of ",
                radius, wanted);
  std::string what = options.mesh + line + options.onto;
  std::snprintf(line, sizeof line, "; --scale (now %g) gives its metres per unit, about %.3g",
                fine_scale, fine_scale * wanted / radius);
  throw InputError(what + line + ", --onto-scale those of the other");
}

BakeParams params_of(const Common& common, const BakeOptions& options) {
  return {.texels = options.texels, .seed = common.seed};
}

TextureAsset bake_onto(const Common& common, const BakeOptions& options) {
  double scale = options.scale.value_or(1.0);
  TriangleMesh coarse;
  if (options.level) {
    Onto onto = load_onto_clod(options);
    scale = options.scale.value_or(onto.fine_scale);
    coarse = level_surface(options, std::move(onto.surfaces), *options.level);
  } else {
    coarse = load(common, options, options.onto, "--onto", options.onto_scale.value_or(scale));
  }
  const TriangleMesh fine = load(common, options, options.mesh, "FINE", scale);
  refuse_other_sizes(options, fine, scale, coarse);
  return bake_surface(fine, coarse, params_of(common, options), options.mesh);
}

LevelTextures bake_onto_levels(const Common& common, const BakeOptions& options) {
  const Onto onto = load_onto_clod(options);
  const std::vector<TriangleMesh>& levels = onto.surfaces;
  const double scale = options.scale.value_or(onto.fine_scale);
  const TriangleMesh fine = load(common, options, options.mesh, "FINE", scale);
  refuse_other_sizes(options, fine, scale, levels[0]);
  Progress bar("baking onto " + options.onto, "levels", !common.quiet);
  return {bake_levels(fine, levels, params_of(common, options), options.mesh, [&](double share) {
    bar.update(share, share * static_cast<double>(levels.size()));
  })};
}

TextureAsset bake_map(const BakeOptions& options) {
  const HeightImage image = read_height_file(options.height);
  if (models::is_model_uri(options.mesh) || is_clod_file(options.mesh))
    throw InputError(options.mesh +
                     ": no texture coordinates, in it as a whole, expected an OBJ with vt");
  TriangleMesh coarse = load_usable_mesh(options.mesh, options.scale.value_or(1.0));
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
    for (const char* key : {"fit_error_rms", "fit_error_max", "crack_max", "distortion_max",
                            "texel_size", "amplitude"})
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
  out << j["width"] << " x " << j["height"] << " texels of " << j["texel_size"].get<double>()
      << " m in " << j["charts"] << " charts over " << j["triangles"] << " triangles\n  relief +-"
      << j["amplitude"].get<double>() << " m, distortion at most "
      << j["distortion_max"].get<double>() << "\n";
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
    print_error("bake: " + wrong);
    return kUsage;
  }
  const auto start = std::chrono::steady_clock::now();
  ordered_json report;
  std::string bytes;
  if (options.height.empty() && is_clod_file(options.onto) && !options.level) {
    const LevelTextures textures = bake_onto_levels(common, options);
    if (textures.levels.size() == 1 && !textures.levels[0])
      throw InputError(options.onto +
                       ": no simplified levels, in its table, expected some to bake onto");
    bytes = format_level_textures(textures);
    report = levels_json(textures);
  } else {
    const TextureAsset asset =
        options.height.empty() ? bake_onto(common, options) : bake_map(options);
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
  CLI::App* verb = add_verb(app, common, "bake", "bake a haptic texture",
                            [&common, options] { return bake(common, *options); });
  verb->add_option("MESH", options->mesh,
                   "the fine surface, or with --height the coarse one, an OBJ with vt")
      ->required();
  verb->add_option("--onto", options->onto,
                   "coarse surface: a mesh, procedural:NAME or a .clod file");
  verb->add_option(
          "--level", options->level,
          "of a .clod file: onto this one alone, as a plain surface; all of them by default")
      ->check(CLI::Range(0, 1000));
  verb->add_option("--height", options->height, "height map: PGM or grey PNG, 8 or 16 bits");
  verb->add_option("--amplitude", options->amplitude,
                   "white lies this far outside, black inside [m]");
  verb->add_option("-o,--output", options->out, ".tex file to write")->required();
  verb->add_option("--texels", options->texels, "along each side of the map; with --onto only")
      ->check(CLI::Range(16, kMaxTextureSide / 2));
  verb->add_option("--scale", options->scale,
                   "metres per unit of MESH; by default as the .clod was built with, else 1");
  verb->add_option(
      "--onto-scale", options->onto_scale,
      "metres per unit of --onto; by default 1 of a .clod, which is in metres, else as --scale");
  verb->add_flag("--repair", options->repair, "take repairable meshes and repair them");
}

}  // namespace thigma::app
