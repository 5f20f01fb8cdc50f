// thigma repair MESH -o OUT: a repairable mesh made usable, and with --shell any other.

#include <iostream>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "json_out.h"
#include "mesh_report.h"
#include "number_text.h"
#include "progress.h"
#include "verbs.h"

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/import/inspect.h"
#include "thigma/import/read_mesh.h"
#include "thigma/import/repair.h"
#include "thigma/import/shell.h"
#include "thigma/import/write_mesh.h"
#include "thigma/models/make_model.h"

namespace thigma::app {
namespace {

struct RepairOptions {
  std::string in, out;
  bool is_largest = false, is_shell = false;
  std::optional<double> wrap;  // cells of the shell, times the radius
};

struct Repaired {
  TriangleMesh mesh;
  std::vector<std::string> done;
  std::optional<Shell> shell;
};

void say_shell(Repaired& repaired) {
  const Shell& s = *repaired.shell;
  repaired.done.push_back("wrapped in a shell, with cells of " + with_unit(s.cell, "m") +
                          ": it lies at most " + with_unit(s.to_mesh.bound, "m") +
                          " from the mesh, and the mesh where it can be touched at most " +
                          with_unit(s.from_mesh.bound, "m") + " from it");
  if (s.hidden_share > 0.0)
    repaired.done.push_back(percent(s.hidden_share) + " of the area left inside, at most " +
                            with_unit(s.hidden.bound, "m") + " from the shell");
}

Repaired work(const Common& common, const RepairOptions& options) {
  const MeshFile file =
      models::is_model_uri(options.in)
          ? merge_equal_positions(models::make_model(models::parse_model_uri(options.in, "MESH")))
          : read_mesh(options.in);
  Repaired repaired{file.mesh, {}, std::nullopt};
  if (options.is_largest) {
    LargestComponent largest = keep_largest_component(repaired.mesh);
    if (largest.left_out > 0)
      repaired.done.push_back(std::to_string(largest.left_out) + " smaller components left out, " +
                              percent(largest.area_left_out) + " of the area");
    repaired.mesh = std::move(largest.mesh);
  }
  if (options.is_shell || options.wrap) {
    Progress bar("wrapping " + options.in, "triangles", !common.quiet);
    const auto triangles = static_cast<double>(repaired.mesh.triangles.size());
    ShellParams params{.cell = options.wrap.value_or(kShellCell),
                       .progress = [&](double share) { bar.update(share, triangles); }};
    repaired.shell = wrap_in_shell(repaired.mesh, options.in, params);
    repaired.mesh = repaired.shell->mesh;
    say_shell(repaired);
  } else {
    RepairResult result = repair_mesh(repaired.mesh, options.in);
    repaired.mesh = std::move(result.mesh);
    for (std::string& done : result.repairs) repaired.done.push_back(std::move(done));
  }
  return repaired;
}

nlohmann::ordered_json distance_json(const LargestDistance& d) {
  return {{"met", d.met}, {"bound", d.bound}};
}

nlohmann::ordered_json shell_json(const Shell& s) {
  return {{"cell", s.cell},
          {"to_mesh", distance_json(s.to_mesh)},
          {"from_mesh", distance_json(s.from_mesh)},
          {"hidden_share", s.hidden_share},
          {"hidden", s.hidden_share > 0.0 ? distance_json(s.hidden) : nlohmann::ordered_json()},
          {"vertices_held", s.vertices_held}};
}

int repair(const Common& common, const RepairOptions& options) {
  const Repaired repaired = work(common, options);
  const MeshFormat format = format_for_name(options.out);
  const std::string bytes = format_mesh(repaired.mesh, format, options.out);
  // What a reader will find: single precision, as of STL, may merge what was just taken apart.
  MeshReport report = inspect_mesh(parse_mesh(bytes, options.out), options.out);
  if (report.verdict != MeshVerdict::usable) {
    throw InputError(
        options.in + ": " + report.reasons.front() + " once written as " + format_name(format) +
        ", in the mesh as a whole, expected a format that keeps it usable, such as PLY or OBJ");
  }
  write_file(options.out, bytes);
  if (common.json) {
    nlohmann::ordered_json json = mesh_report_json(report);
    json["repairs"] = repaired.done;
    json["shell"] = repaired.shell ? shell_json(*repaired.shell) : nlohmann::ordered_json();
    print_json(json);
    return kDone;
  }
  for (const std::string& done : repaired.done) std::cout << "repaired: " << done << '\n';
  if (repaired.done.empty()) std::cout << "nothing to repair\n";
  std::cout << mesh_report_text(report) << std::flush;
  return kDone;
}

}  // namespace

void add_repair(CLI::App& app, Common& common) {
  const auto options = std::make_shared<RepairOptions>();
  CLI::App* verb = add_verb(app, common, "repair", "make a mesh usable: repair it, or wrap it",
                            [&common, options] { return repair(common, *options); });
  verb->add_option("MESH", options->in,
                   mesh_kind_names() + ", recognised by content, or procedural:NAME")
      ->required();
  verb->add_option("-o,--output", options->out, "file to write: " + written_mesh_endings())
      ->required();
  verb->add_flag("--largest", options->is_largest, "only the component with the largest area");
  CLI::Option* shell = verb->add_flag(
      "--shell", options->is_shell,
      "wrap it, whatever it is, in a watertight surface, and say how far the two are apart");
  verb->add_option("--wrap", options->wrap,
                   "the same, with cells of this share of the radius: 0.03 by --shell, finer ones "
                   "are slower")
      ->excludes(shell);
}

}  // namespace thigma::app
