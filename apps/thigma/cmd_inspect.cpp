// thigma inspect MESH: what a mesh is like, and whether it can be used.

#include <iostream>
#include <memory>

#include "json_out.h"
#include "mesh_report.h"
#include "verbs.h"

#include "thigma/import/inspect.h"
#include "thigma/import/read_mesh.h"
#include "thigma/models/make_model.h"

namespace thigma::app {
namespace {

MeshReport report_on(const std::string& path) {
  if (!models::is_model_uri(path)) return inspect_mesh(read_mesh(path), path);
  MeshReport report = inspect_mesh(models::make_model(models::parse_model_uri(path, "MESH")));
  report.file = path;
  report.format = "procedural";
  return report;
}

int inspect(const Common& common, const std::string& path) {
  const MeshReport report = report_on(path);
  if (common.json)
    print_json(mesh_report_json(report));
  else
    std::cout << mesh_report_text(report) << std::flush;
  if (report.verdict != MeshVerdict::rejected) return kDone;
  print_error(path + ": " + report.reasons.front() +
              ", in the mesh as a whole, expected a usable or repairable mesh");
  return kBadInput;
}

}  // namespace

void add_inspect(CLI::App& app, Common& common) {
  const auto path = std::make_shared<std::string>();
  CLI::App* verb = add_verb(app, common, "inspect", "Report on a mesh: counts, measures, verdict",
                            [&common, path] { return inspect(common, *path); });
  verb->add_option("MESH", *path,
                   std::string(kMeshFormats) + ", recognised by content, or procedural:NAME")
      ->required();
}

}  // namespace thigma::app
