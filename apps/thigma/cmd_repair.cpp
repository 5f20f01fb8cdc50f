// thigma repair MESH -o OUT: a repairable mesh made usable.

#include <iostream>
#include <memory>

#include "json_out.h"
#include "mesh_report.h"
#include "verbs.h"

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/import/inspect.h"
#include "thigma/import/read_mesh.h"
#include "thigma/import/repair.h"
#include "thigma/import/write_mesh.h"
#include "thigma/models/make_model.h"

namespace thigma::app {
namespace {

struct RepairPaths {
  std::string in, out;
};

int repair(const Common& common, const RepairPaths& paths) {
  const MeshFile file =
      models::is_model_uri(paths.in)
          ? merge_equal_positions(models::make_model(models::parse_model_uri(paths.in, "MESH")))
          : read_mesh(paths.in);
  const RepairResult result = repair_mesh(file.mesh, paths.in);
  const MeshFormat format = format_for_name(paths.out);
  const std::string bytes = format_mesh(result.mesh, format, paths.out);
  // What a reader will find: single precision, as of STL, may merge what was just taken apart.
  MeshReport report = inspect_mesh(parse_mesh(bytes, paths.out), paths.out);
  if (report.verdict != MeshVerdict::usable) {
    throw InputError(
        paths.in + ": " + report.reasons.front() + " once written as " + format_name(format) +
        ", in the mesh as a whole, expected a format that keeps it usable, such as PLY or OBJ");
  }
  write_file(paths.out, bytes);
  if (common.json) {
    nlohmann::ordered_json json = mesh_report_json(report);
    json["repairs"] = result.repairs;
    print_json(json);
    return kDone;
  }
  for (const std::string& done : result.repairs) std::cout << "repaired: " << done << '\n';
  if (result.repairs.empty()) std::cout << "nothing to repair\n";
  std::cout << mesh_report_text(report) << std::flush;
  return kDone;
}

}  // namespace

void add_repair(CLI::App& app, Common& common) {
  const auto paths = std::make_shared<RepairPaths>();
  CLI::App* verb = add_verb(app, common, "repair", "Make a repairable mesh usable",
                            [&common, paths] { return repair(common, *paths); });
  verb->add_option("MESH", paths->in,
                   std::string(kMeshFormats) + ", recognised by content, or procedural:NAME")
      ->required();
  verb->add_option("-o,--output", paths->out, "file to write: .ply, .stl, .off, else OBJ")
      ->required();
}

}  // namespace thigma::app
