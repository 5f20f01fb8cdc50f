// Table 4.1: fine and coarse triangles of the textured models, and the bounding volumes over the
// coarse ones.

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/common/texture_experiments.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/convex/count_patches.h"
#include "thigma/mesh/measure.h"
#include "thigma/models/textured_model.h"
#include "thigma/models/textured_parts.h"
#include "thigma/texture/bake.h"

namespace thigma::experiments {
namespace table_4_1 {
namespace {

struct Row41 {
  const char* name;
  const char* model;
  double fine, coarse, volumes;  // of the text
};

constexpr Row41 kRows[] = {
    {"Block", "ridged_block", 65536, 16, 1}, {"Gear", "gear", 25600, 1600, 1},
    {"Hammer", "hammer", 433152, 518, 210},  {"CAD Part", "cad_part", 658432, 720, 390},
    {"File", "file", 285824, 632, 113},      {"Torus", "helicoidal_torus", 128000, 532, 114}};

/// Triangles of the fine surface: of the mesh there is, or for the block, which has none, of the
/// text's.
double fine_count(const Row41& row) {
  double count = 0.0;
  for (const models::TexturedSheet& sheet : models::textured_part(row.model))
    count += models::fine_triangles(sheet);
  return count > 0.0 ? count : std::numeric_limits<double>::quiet_NaN();
}

/// The fine mesh baked onto the coarse one: what is off, both ways, over the radius [%].
struct Fit {
  double rms = 0.0, largest = 0.0, crack = 0.0, distortion = 0.0;
};

Fit bake_part(const Row41& row, const TriangleMesh& coarse, const Context& context) {
  const TriangleMesh fine = models::make_fine_sheets(models::textured_part(row.model));
  const BakeFigures f =
      bake_surface(fine, coarse,
                   {.texels = context.quick ? 512 : 1024, .samples = context.quick ? 2000 : 20000},
                   row.name)
          .figures;
  const double percent = 100.0 / enclosing_ball(fine.positions).radius;
  return {percent * f.fit_error_rms.value_or(0.0), percent * f.fit_error_max.value_or(0.0),
          percent * f.crack_max.value_or(0.0), f.distortion_max};
}

/// How far the models are from the text's, the worst of them.
struct Off {
  double fine = 0.0, coarse = 0.0;  // triangles
  // patches of any size of the models that the text has one volume for
  double convex = 0.0;
  // nodes over patches of any size, over the text's volumes, of the others
  double fewest = 1e9, most = 0.0;
  double crack_to_fit = 0.0;
  Fit fit;

  void observe(const Row41& row, double fine_here, double triangles, double parts, double nodes,
               const Fit& here) {
    if (std::isfinite(fine_here)) fine = std::max(fine, std::fabs(fine_here / row.fine - 1.0));
    coarse = std::max(coarse, std::fabs(triangles / row.coarse - 1.0));
    if (row.volumes == 1.0) {
      convex = std::max(convex, parts);
    } else {
      fewest = std::min(fewest, nodes / row.volumes);
      most = std::max(most, nodes / row.volumes);
    }
    fit = {std::max(fit.rms, here.rms), std::max(fit.largest, here.largest),
           std::max(fit.crack, here.crack), std::max(fit.distortion, here.distortion)};
    if (here.largest > 0.0) crack_to_fit = std::max(crack_to_fit, here.crack / here.largest);
  }
};

std::vector<Claim> claims_of(const Off& off) {
  return {
      at_most("fine", "fine triangles off the text's, the worst of five models", off.fine, 0.01),
      at_most("coarse", "coarse triangles off the text's, the worst of six models", off.coarse,
              0.05),
      at_most(
          "convex",
          "convex patches of the coarse block and the coarse gear, whatever their size, the more",
          off.convex, 1.0),
      within("bumpy-least",
             "nodes over patches of any size over the text's volumes, the least of the other four "
             "models",
             off.fewest, 0.5, 2.0),
      within("bumpy-most", "the same, the most", off.most, 0.5, 2.0),
      at_most("fit-rms",
              "fine meshes baked onto the coarse ones: two-sided fit error over the radius, RMS, "
              "worst of the models",
              off.fit.rms, 0.1, "%"),
      at_most("fit-max", "the same, the largest", off.fit.largest, 0.5, "%"),
      at_most(
          "cracks",
          "largest crack at the seams of charts over the largest fit error, worst of the models",
          off.crack_to_fit, 1.0),
      stated("crack-max", "largest crack over the radius", off.fit.crack, "%"),
      stated("distortion", "how much lengths are stretched or squeezed in the charts, at most",
             off.fit.distortion)};
}

}  // namespace
}  // namespace table_4_1

Outcome run_table_4_1(const Context& context) {
  using namespace table_4_1;
  Outcome outcome;
  outcome.tables = {{.name = "data",
                     .columns = {"model", "fine triangles", "fine, text", "coarse triangles",
                                 "coarse, text", "hierarchy nodes", "volumes, text", "patches",
                                 "patches of any size", "nodes of any size", "texels", "relief [m]",
                                 "fit, RMS [% of the radius]", "fit, largest [% of the radius]",
                                 "cracks, largest [% of the radius]", "distortion"}}};
  plot::Series fine{.label = "triangles, fine", .mark = plot::Mark::points},
      coarse{.label = "triangles, coarse", .mark = plot::Mark::points},
      nodes{.label = "volumes, hulls of any size", .mark = plot::Mark::points};
  Off off;
  for (const Row41& row : kRows) {
    tell(context, row.name);
    const HapticTexture texture =
        models::make_textured_model({row.model, context.quick ? 256 : 1024});
    const ClodHierarchy h = build_exact_hierarchy(texture.coarse);
    const double triangles = static_cast<double>(texture.coarse.triangles.size()),
                 volumes = static_cast<double>(h.nodes.size()), fine_here = fine_count(row),
                 parts = count_convex_patches(texture.coarse);
    const double free_volumes = 2.0 * parts - 1.0;  // of a binary tree over patches of any size
    Fit fit;
    if (std::isfinite(fine_here) && (!context.quick || fine_here < 150e3))
      fit = bake_part(row, texture.coarse, context);
    off.observe(row, fine_here, triangles, parts, free_volumes, fit);
    add_row(outcome.tables[0],
            {std::string(row.name), fine_here, row.fine, triangles, row.coarse, volumes,
             row.volumes, static_cast<double>(h.patches.size()), parts, free_volumes,
             static_cast<double>(texture.width) * texture.height, texture.amplitude, fit.rms,
             fit.largest, fit.crack, fit.distortion});
    fine.x.push_back(row.fine);
    fine.y.push_back(fine_here);
    coarse.x.push_back(row.coarse);
    coarse.y.push_back(triangles);
    nodes.x.push_back(row.volumes);
    nodes.y.push_back(free_volumes);
    outcome.claims.push_back(stated(
        std::string("nodes-") + row.model,
        std::string("nodes of the hierarchy, all levels free, hulls of 32 vertices at most: ") +
            row.name + "; the text has " + std::to_string(static_cast<int>(row.volumes)),
        volumes));
  }
  const std::vector<Claim> claims = claims_of(off);
  outcome.claims.insert(outcome.claims.begin(), claims.begin(), claims.end());
  const plot::Series equal{
      .label = "equal", .x = {1.0, 1e6}, .y = {1.0, 1e6}, .is_dashed = true, .width = 1.0};
  outcome.figure = {
      .title = "Complexity of the textured models (Table 4.1)",
      .panels = {{.title = "",
                  .x = {.label = "triangles or bounding volumes, the text's", .is_log = true},
                  .y = {.label = "here", .is_log = true},
                  .series = {fine, coarse, nodes, equal}}},
      .width = 720,
      .panel_height = 420};
  return outcome;
}

}  // namespace thigma::experiments
