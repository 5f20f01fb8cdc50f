#include "thigma/import/shell.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <utility>
#include <vector>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/import/detail/shell_lattice.h"
#include "thigma/import/detail/shell_snap.h"
#include "thigma/import/read_mesh.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

constexpr double kOffset = 0.55;  // cells; above half a one, so that nothing leaks through a wall
constexpr double kRest = 1.0 / 30.0;  // cells between the snapped shell and the mesh
// Of the largest coordinate: smaller cells have less than a few thousand positions across, and what
// the lattice promises drowns in rounding.
constexpr double kLeastCell = 0x1.0p-40;
constexpr double kSmall = 1e-3;               // cells: deviations below are not told apart
constexpr double kMostPoints = 64e6;          // of the lattice
constexpr std::size_t kMostNear = 8'000'000;  // of them, near the surface
constexpr std::size_t kMostPieces = 4'000'000;

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// As reading leaves a mesh: without vertices that no triangle uses, and with an extent.
TriangleMesh checked(const TriangleMesh& mesh, const std::string& name, Ball& ball) {
  TriangleMesh merged = merge_equal_positions(mesh).mesh;
  ball = enclosing_ball(merged.positions);
  if (!(ball.radius > 0.0))
    throw InputError(name +
                     ": it has no triangle with an extent, in the mesh as a whole, expected "
                     "something that a shell goes around");
  return merged;
}

TrianglePiece corners_of(const TriangleMesh& mesh, const std::array<std::int32_t, 3>& t) {
  return {mesh.positions[idx(t[0])], mesh.positions[idx(t[1])], mesh.positions[idx(t[2])]};
}

double area_of(const TrianglePiece& c) { return 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm(); }

// The mesh in pieces no larger than a cell: those that are seen from outside, and the others.
struct SortedPieces {
  std::vector<TrianglePiece> seen, hidden;
};

SortedPieces sort_pieces(const TriangleMesh& mesh, const detail::ShellLattice& lattice) {
  SortedPieces sorted;
  std::vector<TrianglePiece> open;
  for (const auto& t : mesh.triangles) {
    open.push_back(corners_of(mesh, t));
    while (!open.empty()) {
      const TrianglePiece c = open.back();
      open.pop_back();
      std::size_t longest = 0;
      double length = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double side = (c[(k + 1) % 3] - c[k]).norm();
        if (side > length) {
          length = side;
          longest = k;
        }
      }
      const std::size_t pieces = sorted.seen.size() + sorted.hidden.size() + open.size();
      if (length > lattice.cell && pieces < kMostPieces) {
        const std::size_t next = (longest + 1) % 3, tip = (longest + 2) % 3;
        const Vec3 middle = 0.5 * (c[longest] + c[next]);
        open.push_back({c[longest], middle, c[tip]});
        open.push_back({middle, c[next], c[tip]});
        continue;
      }
      const bool is_seen = detail::is_seen_from_outside(lattice, (c[0] + c[1] + c[2]) / 3.0);
      (is_seen ? sorted.seen : sorted.hidden).push_back(c);
    }
  }
  return sorted;
}

double sum_areas(const std::vector<TrianglePiece>& pieces) {
  double area = 0.0;
  for (const TrianglePiece& piece : pieces) area += area_of(piece);
  return area;
}

// Measures both ways.
void measure_deviation(Shell& shell, const TriangleMesh& mesh, const TriangleTree& tree,
                       const detail::ShellLattice& lattice) {
  std::vector<TrianglePiece> of_shell;
  std::vector<std::int32_t> all(shell.mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  for (const auto& t : shell.mesh.triangles) of_shell.push_back(corners_of(shell.mesh, t));
  const TriangleTree shell_tree = build_triangle_tree(shell.mesh, std::move(all));
  const SortedPieces pieces = sort_pieces(mesh, lattice);
  const double small = kSmall * lattice.cell;
  shell.to_mesh = largest_distance(of_shell, mesh, tree, small);
  shell.from_mesh = largest_distance(pieces.seen, shell.mesh, shell_tree, small);
  shell.hidden = largest_distance(pieces.hidden, shell.mesh, shell_tree, small);
  const double hidden_area = sum_areas(pieces.hidden);
  const double area = hidden_area + sum_areas(pieces.seen);
  if (area > 0.0) shell.hidden_share = hidden_area / area;
}

[[noreturn]] void refuse_far(const std::string& name, const std::string& what, const Ball& ball) {
  throw InputError(name + ": " + what +
                   ", in the mesh as a whole, expected one nearer to the origin: "
                   "it is " +
                   shown(ball.center.norm() / ball.radius) + " radii away");
}

// What the lattice promises, seen once more by inspection.
void check_sound(const Shell& shell, const Ball& ball, const std::string& name) {
  const MeshReport report = inspect_mesh(shell.mesh);
  if (report.verdict == MeshVerdict::usable && report.closed && report.self_intersections == 0 &&
      report.self_intersections_counted)
    return;
  const std::string why = report.reasons.empty() ? "triangles meet" : report.reasons.front();
  refuse_far(name, "its shell is not sound, " + why, ball);
}

}  // namespace

Shell wrap_in_shell(const TriangleMesh& mesh, const std::string& name, const ShellParams& params) {
  if (!(params.cell > 0.0 && params.cell <= 0.5))
    throw InputError(name + ": cells of " + shown(params.cell) +
                     " of the radius, as given, expected more than 0 and at most 0.5");
  Ball ball;
  const TriangleMesh whole = checked(mesh, name, ball);
  const double cell = params.cell * ball.radius, offset = kOffset * cell;
  const Bounds bounds = bounds_of(whole.positions);
  const double place = bounds.min.cwiseAbs().cwiseMax(bounds.max.cwiseAbs()).maxCoeff();
  if (cell < kLeastCell * place) refuse_far(name, "positions have too few digits for cells", ball);
  const auto refuse_fine = [&](const std::string& what) {
    throw InputError(name + ": cells of " + shown(params.cell) + " of the radius make " + what +
                     ", as given, expected larger cells");
  };
  const double points = detail::lattice_points(bounds.max - bounds.min, cell, offset);
  if (!(points <= kMostPoints))
    refuse_fine(shown(points) + " lattice points, above " + shown(kMostPoints));
  const auto report = [&](double from, double to) {
    return [&params, from, to](double share) {
      if (params.progress) params.progress(from + (to - from) * share);
    };
  };
  std::vector<std::int32_t> all(whole.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const TriangleTree tree = build_triangle_tree(whole, std::move(all));
  const std::optional<detail::ShellLattice> lattice =
      detail::build_shell_lattice(whole, tree, cell, offset, kMostNear, report(0.0, 0.4));
  if (!lattice) refuse_fine("more than 8 million lattice points near the surface");
  Shell shell;
  shell.cell = cell;
  shell.mesh = detail::cut_shell_lattice(*lattice);
  shell.vertices_held =
      detail::snap_shell(shell.mesh, whole, tree, kRest * cell, report(0.45, 0.8));
  measure_deviation(shell, whole, tree, *lattice);
  check_sound(shell, ball, name);
  if (params.progress) params.progress(1.0);
  return shell;
}

bool can_wrap(const MeshReport& report) {
  return report.components > 0;  // inspection came as far as looking at them
}

LargestComponent keep_largest_component(const TriangleMesh& mesh) {
  LargestComponent largest;
  const Components c = connect_over_edges(mesh, build_edge_table(mesh));
  std::vector<double> area(static_cast<std::size_t>(c.count), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    area[idx(c.of_triangle[t])] += area_of(corners_of(mesh, mesh.triangles[t]));
  if (area.empty()) return largest;
  const auto kept =
      static_cast<std::int32_t>(std::max_element(area.begin(), area.end()) - area.begin());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (c.of_triangle[t] == kept) largest.mesh.triangles.push_back(mesh.triangles[t]);
  largest.mesh.positions = mesh.positions;
  largest.mesh = merge_equal_positions(std::move(largest.mesh)).mesh;  // only what is used
  largest.left_out = c.count - 1;
  const double whole = std::accumulate(area.begin(), area.end(), 0.0);
  if (whole > 0.0) largest.area_left_out = 1.0 - area[idx(kept)] / whole;
  return largest;
}

}  // namespace thigma
