#include "thigma/import/inspect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "thigma/import/duplicates.h"
#include "thigma/import/weld.h"
#include "thigma/mesh/predicates.h"
#include "thigma/mesh/self_intersections.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

using Triangle = std::array<std::int32_t, 3>;

// Coordinates at which squares of areas still have all their digits; a smaller part has no
// measurable surface.
constexpr double kMinRadius = 1e-50;  // [m]

constexpr double kRounding = 0x1.0p-50;  // of a position: four units in its last place

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// "1 edge has", "3 edges have": counted sentences in good grammar.
std::string counted(std::int64_t n, const char* one, const char* many, const char* tail_one,
                    const char* tail_many) {
  return std::to_string(n) + ' ' + (n == 1 ? one : many) + ' ' + (n == 1 ? tail_one : tail_many);
}

// Everything of the mesh that several counts need.
struct Inspection {
  const TriangleMesh& mesh;
  MeshReport& report;
  EdgeTable table;
  Components components;  // over edges: two solids that touch at a vertex are two
  Orientation orientation;
};

Inspection begin_inspection(const TriangleMesh& mesh, MeshReport& report) {
  Inspection inspection{mesh, report, build_edge_table(mesh), {}, {}};
  inspection.components = connect_over_edges(mesh, inspection.table);
  inspection.orientation = orient_sheets(mesh, inspection.table);
  return inspection;
}

struct ComponentState {
  bool is_closed = true;
  bool is_orientable = true;
  bool is_consistent = true;  // no triangle has to be turned over
  double volume = 0.0;        // of the consistent orientation nearest the given one [m^3]
  double area = 0.0;
  std::int32_t first_triangle = -1;
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
};

std::vector<ComponentState> measure_components(const Inspection& inspection) {
  std::vector<ComponentState> states(static_cast<std::size_t>(inspection.components.count));
  for (std::size_t t = 0; t < inspection.mesh.triangles.size(); ++t) {
    ComponentState& s = states[static_cast<std::size_t>(inspection.components.of_triangle[t])];
    const Triangle& v = inspection.mesh.triangles[t];
    const auto at = [&](std::size_t k) -> const Vec3& {
      return inspection.mesh.positions[static_cast<std::size_t>(v[k])];
    };
    if (s.first_triangle < 0) {
      s.first_triangle = static_cast<std::int32_t>(t);
      s.min = s.max = at(0);
    }
    // About a vertex of the component itself: a small part far from the rest keeps its digits.
    const Vec3& origin = inspection.mesh.positions[static_cast<std::size_t>(
        inspection.mesh.triangles[static_cast<std::size_t>(s.first_triangle)][0])];
    const Vec3 twice_area = (at(1) - at(0)).cross(at(2) - at(0));
    const double sign = inspection.orientation.is_flipped[t] ? -1.0 : 1.0;
    s.volume += sign * (at(0) - origin).dot(twice_area) / 6.0;
    s.area += 0.5 * twice_area.norm();
    s.is_consistent = s.is_consistent && !inspection.orientation.is_flipped[t];
    const std::size_t sheet = static_cast<std::size_t>(inspection.orientation.sheet_of_triangle[t]);
    s.is_orientable = s.is_orientable && inspection.orientation.is_orientable[sheet];
    for (std::size_t k = 0; k < 3; ++k) {
      s.min = s.min.cwiseMin(at(k));
      s.max = s.max.cwiseMax(at(k));
    }
  }
  for (const MeshEdge& e : inspection.table.edges) {
    if (e.use_count != 1) continue;
    const std::size_t t = static_cast<std::size_t>(inspection.table.uses_of(e)[0].triangle);
    states[static_cast<std::size_t>(inspection.components.of_triangle[t])].is_closed = false;
  }
  return states;
}

bool has_zero_volume(const ComponentState& s) {
  const double extent = (s.max - s.min).maxCoeff();
  const double place = std::max(s.min.cwiseAbs().maxCoeff(), s.max.cwiseAbs().maxCoeff());
  return std::fabs(s.volume) <= s.area * (1e-12 * extent + kRounding * place);
}

// Whether the component lies in another closed one: decided at the middle of a triangle that lies
// on no other surface.
bool lies_in_another(const Inspection& inspection, const InsideTest& test,
                     const std::vector<ComponentState>& states, std::int32_t component) {
  constexpr int kTries = 64;
  int tries = 0;
  for (std::size_t t = 0; t < inspection.mesh.triangles.size() && tries < kTries; ++t) {
    if (inspection.components.of_triangle[t] != component) continue;
    ++tries;
    Vec3 middle = Vec3::Zero();
    for (const std::int32_t v : inspection.mesh.triangles[t])
      middle += inspection.mesh.positions[static_cast<std::size_t>(v)] / 3.0;
    const std::optional<std::vector<std::int32_t>> around =
        test.components_around(middle, component);
    if (!around) continue;
    return std::any_of(around->begin(), around->end(), [&](std::int32_t c) {
      return states[static_cast<std::size_t>(c)].is_closed;
    });
  }
  return false;
}

std::vector<std::int32_t> inside_out_components(const Inspection& inspection,
                                                const std::vector<ComponentState>& states) {
  std::vector<std::int32_t> negative;
  for (std::int32_t c = 0; c < inspection.components.count; ++c) {
    const ComponentState& s = states[static_cast<std::size_t>(c)];
    if (s.is_closed && s.is_orientable && s.is_consistent && s.volume < 0.0 &&
        !has_zero_volume(s)) {
      negative.push_back(c);
    }
  }
  if (negative.empty() || inspection.components.count == 1) return negative;
  const InsideTest test(inspection.mesh, inspection.components);
  std::erase_if(negative,
                [&](std::int32_t c) { return lies_in_another(inspection, test, states, c); });
  return negative;
}

void count_components(const Inspection& inspection, const std::vector<ComponentState>& states) {
  for (const ComponentState& s : states) {
    inspection.report.nonorientable_components += !s.is_orientable;
    inspection.report.zero_volume_components +=
        s.is_closed && s.is_orientable && has_zero_volume(s);
  }
  inspection.report.inside_out_components =
      static_cast<std::int64_t>(inside_out_components(inspection, states).size());
}

// Components as repair will leave them, each face once and no fin. One that is closed only because
// each of its faces has its back too encloses nothing.
void count_distinct_components(const TriangleMesh& mesh, MeshReport& report) {
  const DistinctFaces faces = list_distinct_faces(mesh);
  const std::vector<bool> is_fin = find_fins(mesh, faces);
  TriangleMesh distinct{mesh.positions, {}};
  std::vector<bool> is_folded;
  for (std::size_t i = 0; i < faces.triangle.size(); ++i) {
    if (is_fin[i]) continue;
    distinct.triangles.push_back(mesh.triangles[static_cast<std::size_t>(faces.triangle[i])]);
    is_folded.push_back(faces.net[i] == 0);
  }
  const Inspection inspection = begin_inspection(distinct, report);
  std::vector<ComponentState> states = measure_components(inspection);
  std::vector<bool> is_all_folded(states.size(), true);
  for (std::size_t t = 0; t < is_folded.size(); ++t)
    if (!is_folded[t])
      is_all_folded[static_cast<std::size_t>(inspection.components.of_triangle[t])] = false;
  for (std::size_t c = 0; c < states.size(); ++c) {
    if (!is_all_folded[c] || states[c].is_closed) continue;
    states[c].is_closed = true;
    states[c].volume = 0.0;
  }
  count_components(inspection, states);
}

void count_topology(Inspection& inspection) {
  MeshReport& report = inspection.report;
  for (const MeshEdge& e : inspection.table.edges) {
    const std::span<const EdgeUse> uses = inspection.table.uses_of(e);
    report.boundary_edges += uses.size() == 1;
    report.nonmanifold_edges += uses.size() > 2;
    report.misoriented_edges += uses.size() == 2 && uses[0].is_forward == uses[1].is_forward;
  }
  const Fans fans = build_fans(inspection.mesh, inspection.table);
  std::vector<std::int32_t> fan_of_vertex(inspection.mesh.positions.size(), -1);
  std::vector<bool> is_pinched(inspection.mesh.positions.size(), false);
  for (std::size_t c = 0; c < fans.of_corner.size(); ++c) {
    const std::size_t v = static_cast<std::size_t>(inspection.mesh.triangles[c / 3][c % 3]);
    if (fan_of_vertex[v] < 0) fan_of_vertex[v] = fans.of_corner[c];
    if (fan_of_vertex[v] != fans.of_corner[c]) is_pinched[v] = true;
  }
  report.nonmanifold_vertices = std::count(is_pinched.begin(), is_pinched.end(), true);
  for (const std::int32_t first : find_duplicates(inspection.mesh))
    report.duplicate_triangles += first >= 0;
  for (const Triangle& t : inspection.mesh.triangles) {
    const auto at = [&](std::size_t k) -> const Vec3& {
      return inspection.mesh.positions[static_cast<std::size_t>(t[k])];
    };
    report.degenerate_triangles += are_collinear(at(0), at(1), at(2));
  }
  report.closed = report.boundary_edges == 0;
  report.manifold = report.nonmanifold_edges == 0 && report.nonmanifold_vertices == 0;
  report.oriented = report.misoriented_edges == 0;
}

void measure(Inspection& inspection) {
  MeshReport& report = inspection.report;
  const MassProperties mass = mass_properties(inspection.mesh);
  report.area = mass.area;
  if (report.closed && report.manifold && report.oriented) {
    report.volume = mass.volume;
    report.center_of_mass = mass.center_of_mass;
    report.inertia = mass.inertia;
  }
}

void add_reasons(MeshReport& report) {
  const auto reject = [&](std::int64_t n, const char* tail_one, const char* tail_many) {
    if (n > 0) report.reasons.push_back(counted(n, "component", "components", tail_one, tail_many));
  };
  reject(report.nonorientable_components, "cannot be oriented", "cannot be oriented");
  reject(report.zero_volume_components, "is closed but has no volume",
         "are closed but have no volume");
  const bool is_rejected = !report.reasons.empty();
  const auto add = [&](std::int64_t n, const char* one, const char* many, const char* tail_one,
                       const char* tail_many) {
    if (n > 0) report.reasons.push_back(counted(n, one, many, tail_one, tail_many));
  };
  add(report.duplicate_triangles, "triangle", "triangles", "repeats another", "repeat others");
  add(report.nonmanifold_edges, "edge", "edges", "has three or more faces",
      "have three or more faces");
  add(report.nonmanifold_vertices, "vertex", "vertices", "joins more than one fan of faces",
      "join more than one fan of faces");
  add(report.misoriented_edges, "edge", "edges", "lies between faces of opposite orientation",
      "lie between faces of opposite orientation");
  add(report.inside_out_components, "closed component", "closed components", "is inside out",
      "are inside out");
  add(report.unwelded_vertices, "vertex", "vertices", "nearly equals another along a crack",
      "nearly equal others along cracks");
  report.verdict = is_rejected              ? MeshVerdict::rejected
                   : report.reasons.empty() ? MeshVerdict::usable
                                            : MeshVerdict::repairable;
}

double shortest_edge(const Inspection& inspection) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const MeshEdge& e : inspection.table.edges) {
    const Vec3 d = inspection.mesh.positions[static_cast<std::size_t>(e.a)] -
                   inspection.mesh.positions[static_cast<std::size_t>(e.b)];
    shortest = std::min(shortest, d.norm());
  }
  return shortest;
}

void add_warnings(const Inspection& inspection) {
  MeshReport& report = inspection.report;
  if (!report.closed) {
    report.warnings.push_back(
        "the surface is open: it has no volume, and its sides are those of its normals");
  }
  if (report.self_intersections > 0) {
    const char* at_least = report.self_intersections_counted ? "" : "at least ";
    report.warnings.push_back(at_least +
                              counted(report.self_intersections, "pair", "pairs",
                                      "of triangles meets other than at shared vertices or edges",
                                      "of triangles meet other than at shared vertices or edges"));
    if (report.components > 1 && report.volume) {
      report.warnings.push_back("where components overlap, volume and inertia count twice");
    }
  }
  if (report.degenerate_triangles > 0) {
    report.warnings.push_back(counted(report.degenerate_triangles, "triangle", "triangles",
                                      "has no area", "have no area") +
                              ", " + std::to_string(report.triangles_left_out) + " left out");
  }
  const double shortest = shortest_edge(inspection);
  if (shortest < 1e-6 * report.radius) {
    report.warnings.push_back("the shortest edge is " + shown(shortest / report.radius) +
                              " of the radius");
  }
  if (report.center.norm() > 1e4 * report.radius) {
    report.warnings.push_back("the origin is " + shown(report.center.norm() / report.radius) +
                              " radii away: positions have lost as many digits");
  }
  const double extent = (report.bounds.max - report.bounds.min).maxCoeff();
  if (extent > 10.0) {
    report.warnings.push_back("the extent is " + shown(extent) +
                              " m: a file in mm needs --scale 0.001");
  } else if (extent < 1e-3) {
    report.warnings.push_back("the extent is " + shown(extent) + " m: is the unit right?");
  }
}

// What must hold before anything can be computed; false with its reason otherwise.
bool check_values(const TriangleMesh& mesh, MeshReport& report) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].cwiseAbs().maxCoeff() <= kMaxCoordinate && mesh.positions[i].allFinite())
      continue;
    report.reasons.push_back("vertex " + std::to_string(i) + " is not finite or out of range");
    return false;
  }
  const std::int64_t n = static_cast<std::int64_t>(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::int32_t v : mesh.triangles[i]) {
      if (v >= 0 && v < n) continue;
      report.reasons.push_back("triangle " + std::to_string(i) + " names vertex " +
                               std::to_string(v) + ", which does not exist");
      return false;
    }
  }
  return true;
}

void inspect_merged(const TriangleMesh& mesh, const InspectOptions& options, MeshReport& report) {
  const Ball ball = enclosing_ball(mesh.positions);
  report.radius = ball.radius;
  report.center = ball.center;
  report.bounds = bounds_of(mesh.positions);
  if (mesh.triangles.empty() || !(report.radius > kMinRadius)) {
    if (mesh.triangles.empty()) report.bounds = {Vec3::Zero(), Vec3::Zero()};
    report.reasons.push_back(mesh.triangles.empty() ? "it has no triangle"
                                                    : "it is smaller than 1e-50 m");
    return;
  }
  Inspection inspection = begin_inspection(mesh, report);
  report.components = inspection.components.count;
  count_topology(inspection);
  if (report.duplicate_triangles == 0)
    count_components(inspection, measure_components(inspection));
  else
    count_distinct_components(mesh, report);
  report.unwelded_vertices = find_welds(mesh, inspection.table, report.radius).count;
  measure(inspection);
  if (options.self_intersections) {
    const SelfIntersections found = find_self_intersections(mesh);
    report.self_intersections = found.pairs;
    report.self_intersections_counted = found.complete;
  }
  if (!(report.area > 0.0)) {
    report.reasons.push_back("it has no triangle with an area");
  } else {
    add_reasons(report);
  }
  add_warnings(inspection);
}

}  // namespace

std::vector<std::int32_t> find_inside_out_components(const TriangleMesh& mesh) {
  MeshReport unused;
  const Inspection inspection = begin_inspection(mesh, unused);
  return inside_out_components(inspection, measure_components(inspection));
}

const char* verdict_name(MeshVerdict verdict) {
  switch (verdict) {
    case MeshVerdict::usable:
      return "usable";
    case MeshVerdict::repairable:
      return "repairable";
    case MeshVerdict::rejected:
      return "rejected";
  }
  return "";
}

MeshReport inspect_mesh(const MeshFile& file, const std::string& name,
                        const InspectOptions& options) {
  MeshReport report;
  report.file = name;
  report.format = format_name(file.format);
  report.triangles = file.triangles_in_file;
  report.vertices = static_cast<std::int64_t>(file.mesh.positions.size());
  report.vertices_in_file = file.vertices_in_file;
  report.triangles_left_out = file.triangles_left_out;
  report.degenerate_triangles = file.triangles_left_out;
  inspect_merged(file.mesh, options, report);
  if (file.vertices_unused > 0) {
    report.warnings.push_back(counted(file.vertices_unused, "vertex", "vertices",
                                      "belongs to no triangle", "belong to no triangle"));
  }
  return report;
}

MeshReport inspect_mesh(const TriangleMesh& mesh, const InspectOptions& options) {
  MeshReport report;
  report.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  report.vertices = report.vertices_in_file = static_cast<std::int64_t>(mesh.positions.size());
  report.bounds = {Vec3::Zero(), Vec3::Zero()};
  if (!check_values(mesh, report)) return report;
  report = inspect_mesh(merge_equal_positions(mesh), "", options);
  report.format.clear();
  return report;
}

}  // namespace thigma
