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

/// The surface of a simplified level of a .clod file, the coarsest if none is named.
TriangleMesh level_surface(const BakeOptions& options) {
  ClodAsset asset = read_clod(options.onto, options.scale);
  if (asset.meshes.empty())
    throw InputError(options.onto + ": no surfaces of its levels, in its table, expected them");
  const int coarsest = static_cast<int>(asset.meshes.size()) - 1;
  const int level = options.level.value_or(coarsest);
  if (level > coarsest)
    throw InputError(options.onto + ": no level " + std::to_string(level) +
                     " with a surface, in its table, expected at most " + std::to_string(coarsest));
  return std::move(asset.meshes[static_cast<std::size_t>(level)]);
}

TextureAsset bake_onto(const Common& common, const BakeOptions& options) {
  const Tell tell = common.quiet ? Tell{} : [](const std::string& text) {
    std::cerr << "thigma: " << text << "\n";
  };
  const auto load = [&](const std::string& name, const char* role) {
    return load_surface(
        {.name = name, .role = role, .scale = options.scale, .is_repair = options.repair}, tell);
  };
  const TriangleMesh fine = load(options.mesh, "FINE");
  const TriangleMesh coarse =
      is_clod_file(options.onto) ? level_surface(options) : load(options.onto, "--onto");
  return bake_surface(fine, coarse, {.texels = options.texels, .seed = common.seed}, options.mesh);
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

ordered_json report_json(const BakeOptions& options, const TextureAsset& asset,
                         const std::string& bytes, double seconds) {
  const HapticTexture& t = asset.texture;
  const BakeFigures& f = asset.figures;
  ordered_json j;
  j["file"] = options.out;
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
  j["seconds"] = seconds;
  j["file_bytes"] = bytes.size();
  j["sha256"] = hex_text(sha256(bytes));
  return j;
}

std::string report_text(const ordered_json& j) {
  std::ostringstream out;
  const double radius = j["radius"].get<double>();
  out << j["file"].get<std::string>() << ": " << j["width"] << " x " << j["height"] << " texels of "
      << j["texel_size"].get<double>() << " m in " << j["charts"] << " charts over "
      << j["triangles"] << " triangles, radius " << radius << " m\n";
  out << "  relief +-" << j["amplitude"].get<double>() << " m, distortion at most "
      << j["distortion_max"].get<double>() << "\n";
  if (!j["fit_error_rms"].is_null())
    out << "  fit error " << j["fit_error_rms"].get<double>() << " m RMS ("
        << 100.0 * j["fit_error_rms"].get<double>() / radius << " % of the radius), "
        << j["fit_error_max"].get<double>() << " m at most ("
        << 100.0 * j["fit_error_max"].get<double>() / radius << " %), cracks at seams "
        << j["crack_max"].get<double>() << " m\n";
  return out.str();
}

int bake(const Common& common, const BakeOptions& options) {
  if (const std::string wrong = what_is_wrong(options); !wrong.empty()) {
    tell_error("bake: " + wrong);
    return kUsage;
  }
  const auto start = std::chrono::steady_clock::now();
  const TextureAsset asset =
      options.height.empty() ? bake_onto(common, options) : bake_map(options);
  const std::string bytes = format_texture(asset);
  write_file(options.out, bytes);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const ordered_json json = report_json(options, asset, bytes, seconds);
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
                   "coarse surface: a mesh, procedural:NAME or a level of a .clod file");
  verb->add_option("--level", options->level,
                   "of a .clod file; the coarsest with a surface by default")
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
