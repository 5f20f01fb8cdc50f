// `thigma pack SCENE -o F.mcap`: a scene with all its files in one, to send.

#include <cstdio>
#include <string>
#include <vector>

#include "json_out.h"
#include "named_scene.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/scene/packed_scene.h"
#include "thigma/scene/packed_world.h"

namespace thigma::app {
namespace {

int pack(const std::string& name, const std::string& out, const Common& common) {
  if (is_one_file(name, out)) {
    print_error("pack: " + out + " is the scene itself, expected another file");
    return kUsage;
  }
  std::string title;
  std::vector<McapAttachment> files;
  if (is_named_world(name)) {
    const WorldSceneDescription scene = read_named_world(name);
    title = scene.title;
    files = pack_world(scene);
    write_packed_world(out, scene);
  } else {
    const SceneDescription scene = read_named_scene(name);
    title = scene.title;
    files = pack_scene(scene);
    write_packed_scene(out, scene);
  }
  if (common.json) {
    nlohmann::ordered_json json;
    json["file"] = out;
    json["title"] = title;
    json["files"] = files.size();
    print_json(json);
  } else if (!common.quiet) {
    std::fprintf(stderr, "%s, with all its files, is in %s\n", title.c_str(), out.c_str());
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
