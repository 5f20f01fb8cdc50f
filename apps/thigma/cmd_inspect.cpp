// thigma inspect MESH: what a mesh is like, and whether it can be used.

#include <iostream>
#include <memory>

#include "mesh_report.h"
#include "verbs.h"

#include "thigma/mesh/inspect.h"
#include "thigma/mesh/read_mesh.h"

namespace thigma::app {
namespace {

int inspect(const Common& common, const std::string& path) {
  const MeshReport report = inspect_mesh(read_mesh(path), path);
  if (common.json)
    std::cout << mesh_report_json(report).dump() << std::endl;
  else
    std::cout << mesh_report_text(report) << std::flush;
  if (report.verdict != MeshVerdict::rejected) return kDone;
  std::cerr << "thigma: " << path << ": " << report.reasons.front()
            << ", in the mesh as a whole, expected a usable or repairable mesh\n";
  return kBadInput;
}

}  // namespace

void add_inspect(CLI::App& app, Common& common) {
  const auto path = std::make_shared<std::string>();
  CLI::App* verb = add_verb(app, common, "inspect", "Report on a mesh: counts, measures, verdict",
                            [&common, path] { return inspect(common, *path); });
  verb->add_option("MESH", *path, "OBJ, PLY, STL or OFF, recognised by content")->required();
}

}  // namespace thigma::app
