// thigma inspect MESH: what a mesh is like, and whether it can be used.

#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include "json_out.h"
#include "mesh_report.h"
#include "verbs.h"

#include "thigma/import/inspect.h"
#include "thigma/import/read_mesh.h"
#include "thigma/models/make_model.h"

namespace thigma::app {
namespace {

struct Inspected {
  TriangleMesh mesh;
  MeshReport report;
};

Inspected inspect_file(const std::string& path) {
  Inspected inspected;
  if (models::is_model_uri(path)) {
    inspected.mesh = models::make_model(models::parse_model_uri(path, "MESH"));
    inspected.report = inspect_mesh(inspected.mesh);
    inspected.report.file = path;
    inspected.report.format = "procedural";
  } else {
    MeshFile file = read_mesh(path);
    inspected.report = inspect_mesh(file, path);
    inspected.mesh = std::move(file.mesh);
  }
  return inspected;
}

int inspect(const Common& common, const std::string& path) {
  const auto [mesh, report] = inspect_file(path);
  const std::vector<std::string> ways = ways_on(report, mesh);
  if (common.json) {
    nlohmann::ordered_json json = mesh_report_json(report);
    json["ways_on"] = ways;
    print_json(json);
  } else {
    std::cout << mesh_report_text(report);
    for (const std::string& way : ways)
      std::cout << "  way on: thigma " << way << ' ' << path << " -o OUT\n";
    std::cout << std::flush;
  }
  if (report.verdict != MeshVerdict::rejected) return kDone;
  std::string line = path + ": " + report.reasons.front() +
                     ", in the mesh as a whole, expected a usable or repairable mesh";
  for (std::size_t i = 0; i < ways.size(); ++i)
    line += (i == 0 ? "; `thigma " : "` or `thigma ") + ways[i];
  print_error(line + (ways.empty() ? "" : "` makes one of it"));
  return kBadInput;
}

}  // namespace

void add_inspect(CLI::App& app, Common& common) {
  const auto path = std::make_shared<std::string>();
  CLI::App* verb = add_verb(app, common, "inspect", "report on a mesh: counts, measures, verdict",
                            [&common, path] { return inspect(common, *path); });
  verb->add_option("MESH", *path, mesh_kind_names() + ", recognised by content, or procedural:NAME")
      ->required();
}

}  // namespace thigma::app
