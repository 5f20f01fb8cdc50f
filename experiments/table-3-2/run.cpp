// Table 3.2: the seven benchmark models, their levels of detail beside the source's.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/assets.h"

#include "thigma/math/quantile.h"

namespace thigma::experiments {
namespace table_3_2 {
namespace {

/// A row of the source's table.
struct SourceRow {
  const char* model;  // ours
  const char* name;   // the source's
  double triangles, patches, coarse_triangles, coarse_patches, finest_r, coarsest_r;
  int free_levels, levels;
};

constexpr SourceRow kSource[] = {
    {"jaw_lower", "Lower Jaw", 40180, 11323, 386, 64, 144.5, 12.23, 6, 15},
    {"jaw_upper", "Upper Jaw", 47339, 14240, 1038, 222, 117.5, 19.21, 8, 15},
    {"joint_ball", "Ball Joint", 137060, 41913, 122, 8, 169.9, 6.75, 3, 17},
    {"golf_club", "Golf Club", 104888, 27586, 1468, 256, 157.6, 8.31, 8, 16},
    {"golf_ball", "Golf Ball", 177876, 67704, 826, 64, 216.3, 7.16, 6, 18},
    {"cup", "Cup", 64000, 15490, 1532, 241, 71.0, 7.70, 7, 14},
    {"spoon", "Spoon", 86016, 16125, 1074, 61, 230.1, 13.57, 5, 14},
};

/// The same of a hierarchy of ours, and what the claims ask.
struct Row {
  double triangles = 0, patches = 0, coarse_triangles = 0, coarse_patches = 0, finest_r = 0,
         coarsest_r = 0;
  int free_levels = 0, levels = 0;
  double worst_ratio =
      // of a level's patches or triangles, whichever fell more, to those of the one before, but for
      // the last level
      0.0;
  double last_ratio = 0.0;  // of the last simplified level
  double worst_fall = 0.0;  // of a level's resolution to that of the one before; 1: not fallen
  // largest s of the first and last simplified level, over the radius
  double first_deviation = 0.0, last_deviation = 0.0;
};

/// Of the edges of a mesh [m].
double median_edge(const TriangleMesh& mesh) {
  std::vector<double> lengths;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      lengths.push_back((mesh.positions[static_cast<std::size_t>(t[k])] -
                         mesh.positions[static_cast<std::size_t>(t[(k + 1) % 3])])
                            .norm());
  return sample_quantile(lengths, 0.5);
}

double patch_count(const ClodHierarchy& h, std::size_t level) {
  return level == 0 ? static_cast<double>(h.patches.size()) : h.levels[level].patch_count;
}

double triangle_count(const ClodHierarchy& h, std::size_t level) {
  return level == 0 ? h.triangle_count : h.levels[level].triangle_count;
}

Row measure(const ClodHierarchy& h) {
  Row row;
  row.levels = static_cast<int>(h.levels.size());
  std::size_t simplified = 0;
  for (const ClodLevel& level : h.levels) row.free_levels += level.is_free ? 1 : 0;
  while (simplified + 1 < h.levels.size() && !h.levels[simplified + 1].is_free) ++simplified;
  row.triangles = triangle_count(h, 0);
  row.patches = patch_count(h, 0);
  row.coarse_triangles = triangle_count(h, simplified);
  row.coarse_patches = patch_count(h, simplified);
  if (simplified == 0) return row;
  row.finest_r = h.levels[1].resolution * h.radius;
  row.coarsest_r = h.levels[simplified].resolution * h.radius;
  row.first_deviation = h.levels[1].deviation_max / h.radius;
  row.last_deviation = h.levels[simplified].deviation_max / h.radius;
  for (std::size_t i = 1; i <= simplified; ++i) {
    const double ratio = std::min(patch_count(h, i) / patch_count(h, i - 1),
                                  triangle_count(h, i) / triangle_count(h, i - 1));
    if (i < simplified)
      row.worst_ratio = std::max(row.worst_ratio, ratio);
    else
      row.last_ratio = ratio;
    if (i > 1)
      row.worst_fall =
          std::max(row.worst_fall, h.levels[i].resolution / h.levels[i - 1].resolution);
  }
  return row;
}

void add_model(const SourceRow& source, const ClodHierarchy& h, const Row& row, double seconds,
               Outcome& outcome) {
  add_row(outcome.tables[0],
          {source.name, "here", row.triangles, row.patches, row.coarse_triangles,
           row.coarse_patches, row.finest_r, row.coarsest_r, static_cast<double>(row.free_levels),
           static_cast<double>(row.levels), seconds});
  add_row(outcome.tables[0], {source.name, "source", source.triangles, source.patches,
                              source.coarse_triangles, source.coarse_patches, source.finest_r,
                              source.coarsest_r, static_cast<double>(source.free_levels),
                              static_cast<double>(source.levels), std::nan("")});
  plot::Series patches{.label = source.name, .mark = plot::Mark::line_and_points};
  plot::Series resolution{.mark = plot::Mark::line_and_points};
  for (std::size_t i = 0; i < h.levels.size(); ++i) {
    const ClodLevel& level = h.levels[i];
    add_row(outcome.tables[1],
            {source.name, static_cast<double>(i), level.is_free ? "free" : "simplified",
             triangle_count(h, i), level.is_free ? level.node_count : patch_count(h, i),
             i == 0 ? std::nan("") : level.resolution * h.radius, level.deviation_max / h.radius,
             level.contact_hausdorff_max / h.radius});
    if (level.is_free) continue;
    patches.x.push_back(static_cast<double>(i));
    patches.y.push_back(patch_count(h, i));
    if (i == 0) continue;
    resolution.x.push_back(static_cast<double>(i));
    resolution.y.push_back(level.resolution * h.radius);
  }
  const double coarsest = source.levels - source.free_levels - 1;
  const int color = static_cast<int>(outcome.figure.panels[0].series.size() / 2);
  patches.color = resolution.color = color;
  outcome.figure.panels[0].series.push_back(patches);
  outcome.figure.panels[0].series.push_back({.x = {0.0, coarsest},
                                             .y = {source.patches, source.coarse_patches},
                                             .color = color,
                                             .is_dashed = true,
                                             .width = 1.0});
  outcome.figure.panels[1].series.push_back(resolution);
  outcome.figure.panels[1].series.push_back({.x = {1.0, coarsest},
                                             .y = {source.finest_r, source.coarsest_r},
                                             .color = color,
                                             .is_dashed = true,
                                             .width = 1.0});
}

}  // namespace
}  // namespace table_3_2

Outcome run_table_3_2(const Context& context) {
  using namespace table_3_2;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"model", "whose", "triangles", "patches", "coarsest triangles",
                   "coarsest patches", "r finest (unit radius)", "r coarsest (unit radius)",
                   "free levels", "levels", "build CPU [s]"}},
      {.name = "levels",
       .columns = {"model", "level", "kind", "triangles", "patches", "r (unit radius)",
                   "largest deviation / radius", "largest hausdorff / radius"}}};
  outcome.figure = {
      .title = "Contact levels of detail of the benchmark models (Table 3.2)",
      .note = "solid: built here; dashed: between the source's finest and coarsest level",
      .panels = {{.title = "Convex patches",
                  .x = {.label = "level"},
                  .y = {.label = "patches", .is_log = true}},
                 {.title = "Resolution at unit radius",
                  .x = {.label = "level"},
                  .y = {.label = "r x radius", .is_log = true}}},
      .columns = 2,
      .width = 1100,
      .panel_height = 400};
  std::string coarsest_of;  // whose coarsest level has the largest share of patches
  double ratio = 0.0, last = 0.0, coarse = 0.0, fall = 0.0, free_levels = 0.0;
  double fine = 1e300, first_off = 0.0, last_off = 0.0;
  for (const SourceRow& source : kSource) {
    const std::string uri = model_uri(source.model, static_cast<int>(source.triangles));
    tell(context, std::string("building ") + source.name);
    const ClodHierarchy& h = timed_levels_of(*context.assets, uri);
    const Row row = measure(h);
    add_model(source, h, row, context.assets->seconds[uri], outcome);
    ratio = std::max(ratio, row.worst_ratio);
    last = std::max(last, row.last_ratio);
    // Either is few: 2 % of the original's, or 1.5 times what the source's simplified levels end
    // with.
    const double share = std::min(row.coarse_patches / row.patches / 0.02,
                                  row.coarse_patches / (1.5 * source.coarse_patches));
    if (share > coarse) coarsest_of = source.name;
    coarse = std::max(coarse, share);
    fine = std::min(fine, row.finest_r * median_edge(make_mesh(uri)) / h.radius);
    first_off = std::max(first_off, 100.0 * row.first_deviation);
    last_off = std::max(last_off, 100.0 * row.last_deviation);
    fall = std::max(fall, row.worst_fall);
    free_levels = std::max(free_levels, static_cast<double>(row.free_levels));
  }
  outcome.claims = {
      at_most("levels",
              "patches, or triangles, halve from level to level, but into the coarsest: largest "
              "ratio of the lesser of the two",
              ratio, 0.5),
      stated("last", "ratio of patches into the coarsest simplified level, largest", last),
      at_most("coarse",
              "patches of the coarsest simplified level over 2 % of the original's, or over 1.5 "
              "times the source's, the lesser; "
              "largest: " +
                  coarsest_of,
              coarse, 1.0),
      at_most("near", "largest deviation of a coarsest simplified level, of the radius", last_off,
              7.0, "%"),
      at_least("first",
               "r of a first simplified level over the inverse median edge of the original, least",
               fine, 0.8),
      at_most("first-near", "largest deviation of a first simplified level, of the radius",
              first_off, 1.0, "%"),
      at_most("free", "free levels above the simplified ones, most", free_levels, 8.0, "levels"),
      below("falling", "resolutions fall strictly: largest ratio of a level's to the one before",
            fall, 1.0)};
  return outcome;
}

}  // namespace thigma::experiments
