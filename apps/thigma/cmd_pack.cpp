// `thigma pack SCENE -o F.mcap`: a scene with all its files in one, to send.

#include <cstdio>

#include "json_out.h"
#include "named_scene.h"
#include "run_session.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/scene/packed_scene.h"
#include "thigma/scene/world_scene.h"

namespace thigma::app {
namespace {

int pack(const std::string& name, const std::string& out, const Common& common) {
  if (is_world_scene(name))
    throw InputError(name + ": a world of several bodies, expected a scene of one [object]");
  const SceneDescription scene = read_named_scene(name);
  write_packed_scene(out, scene);
  if (common.json) {
    nlohmann::ordered_json json;
    json["file"] = out;
    json["title"] = scene.title;
    json["files"] = pack_scene(scene).size();
    print_json(json);
  } else if (!common.quiet) {
    std::fprintf(stderr, "%s, with all its files, is in %s\n", scene.title.c_str(), out.c_str());
  }
  return kDone;
}

}  // namespace

void add_pack(CLI::App& app, Common& common) {
  static std::string name, out;
  CLI::App* verb =
      add_verb(app, common, "pack", "put a scene and all its files into one, which run opens",
               [&common] { return pack(name, out, common); });
  verb->add_option("SCENE", name,
                   "scene file (.toml), a packed scene or a recording (.mcap), or a built-in one")
      ->required();
  verb->add_option("-o,--output", out, "file to write (.mcap)")->required();
}

}  // namespace thigma::app
