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
  Inspection in{mesh, report, build_edge_table(mesh), {}, {}};
  in.components = connect_over_edges(mesh, in.table);
  in.orientation = orient_sheets(mesh, in.table);
  return in;
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

std::vector<ComponentState> measure_components(const Inspection& in) {
  std::vector<ComponentState> states(static_cast<std::size_t>(in.components.count));
  for (std::size_t t = 0; t < in.mesh.triangles.size(); ++t) {
    ComponentState& s = states[static_cast<std::size_t>(in.components.of_triangle[t])];
    const Triangle& v = in.mesh.triangles[t];
    const auto at = [&](std::size_t k) -> const Vec3& {
      return in.mesh.positions[static_cast<std::size_t>(v[k])];
    };
    if (s.first_triangle < 0) {
      s.first_triangle = static_cast<std::int32_t>(t);
      s.min = s.max = at(0);
    }
    // About a vertex of the component itself: a small part far from the rest keeps its digits.
    const Vec3& origin = in.mesh.positions[static_cast<std::size_t>(
        in.mesh.triangles[static_cast<std::size_t>(s.first_triangle)][0])];
    const Vec3 twice_area = (at(1) - at(0)).cross(at(2) - at(0));
    const double sign = in.orientation.is_flipped[t] ? -1.0 : 1.0;
    s.volume += sign * (at(0) - origin).dot(twice_area) / 6.0;
    s.area += 0.5 * twice_area.norm();
    s.is_consistent = s.is_consistent && !in.orientation.is_flipped[t];
    const std::size_t sheet = static_cast<std::size_t>(in.orientation.sheet_of_triangle[t]);
    s.is_orientable = s.is_orientable && in.orientation.is_orientable[sheet];
    for (std::size_t k = 0; k < 3; ++k) {
      s.min = s.min.cwiseMin(at(k));
      s.max = s.max.cwiseMax(at(k));
    }
  }
  for (const MeshEdge& e : in.table.edges) {
    if (e.use_count != 1) continue;
    const std::size_t t = static_cast<std::size_t>(in.table.uses_of(e)[0].triangle);
    states[static_cast<std::size_t>(in.components.of_triangle[t])].is_closed = false;
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
bool lies_in_another(const Inspection& in, const InsideTest& test,
                     const std::vector<ComponentState>& states, std::int32_t component) {
  constexpr int kTries = 64;
  int tries = 0;
  for (std::size_t t = 0; t < in.mesh.triangles.size() && tries < kTries; ++t) {
    if (in.components.of_triangle[t] != component) continue;
    ++tries;
    Vec3 middle = Vec3::Zero();
    for (const std::int32_t v : in.mesh.triangles[t])
      middle += in.mesh.positions[static_cast<std::size_t>(v)] / 3.0;
    const std::optional<std::vector<std::int32_t>> around =
        test.components_around(middle, component);
    if (!around) continue;
    return std::any_of(around->begin(), around->end(), [&](std::int32_t c) {
      return states[static_cast<std::size_t>(c)].is_closed;
    });
  }
  return false;
}

std::vector<std::int32_t> inside_out_components(const Inspection& in,
                                                const std::vector<ComponentState>& states) {
  std::vector<std::int32_t> negative;
  for (std::int32_t c = 0; c < in.components.count; ++c) {
    const ComponentState& s = states[static_cast<std::size_t>(c)];
    if (s.is_closed && s.is_orientable && s.is_consistent && s.volume < 0.0 &&
        !has_zero_volume(s)) {
      negative.push_back(c);
    }
  }
  if (negative.empty() || in.components.count == 1) return negative;
  const InsideTest test(in.mesh, in.components);
  std::erase_if(negative, [&](std::int32_t c) { return lies_in_another(in, test, states, c); });
  return negative;
}

void count_components(const Inspection& in, const std::vector<ComponentState>& states) {
  for (const ComponentState& s : states) {
    in.report.nonorientable_components += !s.is_orientable;
    in.report.zero_volume_components += s.is_closed && s.is_orientable && has_zero_volume(s);
  }
  in.report.inside_out_components =
      static_cast<std::int64_t>(inside_out_components(in, states).size());
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
  const Inspection in = begin_inspection(distinct, report);
  std::vector<ComponentState> states = measure_components(in);
  std::vector<bool> is_all_folded(states.size(), true);
  for (std::size_t t = 0; t < is_folded.size(); ++t)
    if (!is_folded[t])
      is_all_folded[static_cast<std::size_t>(in.components.of_triangle[t])] = false;
  for (std::size_t c = 0; c < states.size(); ++c) {
    if (!is_all_folded[c] || states[c].is_closed) continue;
    states[c].is_closed = true;
    states[c].volume = 0.0;
  }
  count_components(in, states);
}

void count_topology(Inspection& in) {
  MeshReport& r = in.report;
  for (const MeshEdge& e : in.table.edges) {
    const std::span<const EdgeUse> uses = in.table.uses_of(e);
    r.boundary_edges += uses.size() == 1;
    r.nonmanifold_edges += uses.size() > 2;
    r.misoriented_edges += uses.size() == 2 && uses[0].is_forward == uses[1].is_forward;
  }
  const Fans fans = build_fans(in.mesh, in.table);
  std::vector<std::int32_t> fan_of_vertex(in.mesh.positions.size(), -1);
  std::vector<bool> is_pinched(in.mesh.positions.size(), false);
  for (std::size_t c = 0; c < fans.of_corner.size(); ++c) {
    const std::size_t v = static_cast<std::size_t>(in.mesh.triangles[c / 3][c % 3]);
    if (fan_of_vertex[v] < 0) fan_of_vertex[v] = fans.of_corner[c];
    if (fan_of_vertex[v] != fans.of_corner[c]) is_pinched[v] = true;
  }
  r.nonmanifold_vertices = std::count(is_pinched.begin(), is_pinched.end(), true);
  for (const std::int32_t first : find_duplicates(in.mesh)) r.duplicate_triangles += first >= 0;
  for (const Triangle& t : in.mesh.triangles) {
    const auto at = [&](std::size_t k) -> const Vec3& {
      return in.mesh.positions[static_cast<std::size_t>(t[k])];
    };
    r.degenerate_triangles += are_collinear(at(0), at(1), at(2));
  }
  r.closed = r.boundary_edges == 0;
  r.manifold = r.nonmanifold_edges == 0 && r.nonmanifold_vertices == 0;
  r.oriented = r.misoriented_edges == 0;
}

void measure(Inspection& in) {
  MeshReport& r = in.report;
  const MassProperties mass = mass_properties(in.mesh);
  r.area = mass.area;
  if (r.closed && r.manifold && r.oriented) {
    r.volume = mass.volume;
    r.center_of_mass = mass.center_of_mass;
    r.inertia = mass.inertia;
  }
}

void add_reasons(MeshReport& r) {
  const auto reject = [&](std::int64_t n, const char* tail_one, const char* tail_many) {
    if (n > 0) r.reasons.push_back(counted(n, "component", "components", tail_one, tail_many));
  };
  reject(r.nonorientable_components, "cannot be oriented", "cannot be oriented");
  reject(r.zero_volume_components, "is closed but has no volume", "are closed but have no volume");
  const bool is_rejected = !r.reasons.empty();
  const auto add = [&](std::int64_t n, const char* one, const char* many, const char* tail_one,
                       const char* tail_many) {
    if (n > 0) r.reasons.push_back(counted(n, one, many, tail_one, tail_many));
  };
  add(r.duplicate_triangles, "triangle", "triangles", "repeats another", "repeat others");
  add(r.nonmanifold_edges, "edge", "edges", "has three or more faces", "have three or more faces");
  add(r.nonmanifold_vertices, "vertex", "vertices", "joins more than one fan of faces",
      "join more than one fan of faces");
  add(r.misoriented_edges, "edge", "edges", "lies between faces of opposite orientation",
      "lie between faces of opposite orientation");
  add(r.inside_out_components, "closed component", "closed components", "is inside out",
      "are inside out");
  add(r.unwelded_vertices, "vertex", "vertices", "nearly equals another along a crack",
      "nearly equal others along cracks");
  r.verdict = is_rejected         ? MeshVerdict::rejected
              : r.reasons.empty() ? MeshVerdict::usable
                                  : MeshVerdict::repairable;
}

double shortest_edge(const Inspection& in) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const MeshEdge& e : in.table.edges) {
    const Vec3 d = in.mesh.positions[static_cast<std::size_t>(e.a)] -
                   in.mesh.positions[static_cast<std::size_t>(e.b)];
    shortest = std::min(shortest, d.norm());
  }
  return shortest;
}

void add_warnings(const Inspection& in) {
  MeshReport& r = in.report;
  if (!r.closed) {
    r.warnings.push_back(
        "the surface is open: it has no volume, and its sides are those of its normals");
  }
  if (r.self_intersections > 0) {
    const char* at_least = r.self_intersections_counted ? "" : "at least ";
    r.warnings.push_back(at_least +
                         counted(r.self_intersections, "pair", "pairs",
                                 "of triangles meets other than at shared vertices or edges",
                                 "of triangles meet other than at shared vertices or edges"));
    if (r.components > 1 && r.volume) {
      r.warnings.push_back("where components overlap, volume and inertia count twice");
    }
  }
  if (r.degenerate_triangles > 0) {
    r.warnings.push_back(
        counted(r.degenerate_triangles, "triangle", "triangles", "has no area", "have no area") +
        ", " + std::to_string(r.triangles_left_out) + " left out");
  }
  const double shortest = shortest_edge(in);
  if (shortest < 1e-6 * r.radius) {
    r.warnings.push_back("the shortest edge is " + shown(shortest / r.radius) + " of the radius");
  }
  if (r.center.norm() > 1e4 * r.radius) {
    r.warnings.push_back("the origin is " + shown(r.center.norm() / r.radius) +
                         " radii away: positions have lost as many digits");
  }
  const double extent = (r.bounds.max - r.bounds.min).maxCoeff();
  if (extent > 10.0) {
    r.warnings.push_back("the extent is " + shown(extent) + " m: a file in mm needs --scale 0.001");
  } else if (extent < 1e-3) {
    r.warnings.push_back("the extent is " + shown(extent) + " m: is the unit right?");
  }
}

// What must hold before anything can be computed; false with its reason otherwise.
bool check_values(const TriangleMesh& mesh, MeshReport& r) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].cwiseAbs().maxCoeff() <= kMaxCoordinate && mesh.positions[i].allFinite())
      continue;
    r.reasons.push_back("vertex " + std::to_string(i) + " is not finite or out of range");
    return false;
  }
  const std::int64_t n = static_cast<std::int64_t>(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::int32_t v : mesh.triangles[i]) {
      if (v >= 0 && v < n) continue;
      r.reasons.push_back("triangle " + std::to_string(i) + " names vertex " + std::to_string(v) +
                          ", which does not exist");
      return false;
    }
  }
  return true;
}

void inspect_merged(const TriangleMesh& mesh, const InspectOptions& options, MeshReport& r) {
  const Ball ball = enclosing_ball(mesh.positions);
  r.radius = ball.radius;
  r.center = ball.center;
  r.bounds = bounds_of(mesh.positions);
  if (mesh.triangles.empty() || !(r.radius > kMinRadius)) {
    if (mesh.triangles.empty()) r.bounds = {Vec3::Zero(), Vec3::Zero()};
    r.reasons.push_back(mesh.triangles.empty() ? "it has no triangle"
                                               : "it is smaller than 1e-50 m");
    return;
  }
  Inspection in = begin_inspection(mesh, r);
  r.components = in.components.count;
  count_topology(in);
  if (r.duplicate_triangles == 0)
    count_components(in, measure_components(in));
  else
    count_distinct_components(mesh, r);
  r.unwelded_vertices = find_welds(mesh, in.table, r.radius).count;
  measure(in);
  if (options.self_intersections) {
    const SelfIntersections found = find_self_intersections(mesh);
    r.self_intersections = found.pairs;
    r.self_intersections_counted = found.complete;
  }
  if (!(r.area > 0.0)) {
    r.reasons.push_back("it has no triangle with an area");
  } else {
    add_reasons(r);
  }
  add_warnings(in);
}

}  // namespace

std::vector<std::int32_t> find_inside_out_components(const TriangleMesh& mesh) {
  MeshReport unused;
  const Inspection in = begin_inspection(mesh, unused);
  return inside_out_components(in, measure_components(in));
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
  MeshReport r;
  r.file = name;
  r.format = format_name(file.format);
  r.triangles = file.triangles_in_file;
  r.vertices = static_cast<std::int64_t>(file.mesh.positions.size());
  r.vertices_in_file = file.vertices_in_file;
  r.triangles_left_out = file.triangles_left_out;
  r.degenerate_triangles = file.triangles_left_out;
  inspect_merged(file.mesh, options, r);
  if (file.vertices_unused > 0) {
    r.warnings.push_back(counted(file.vertices_unused, "vertex", "vertices",
                                 "belongs to no triangle", "belong to no triangle"));
  }
  return r;
}

MeshReport inspect_mesh(const TriangleMesh& mesh, const InspectOptions& options) {
  MeshReport r;
  r.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  r.vertices = r.vertices_in_file = static_cast<std::int64_t>(mesh.positions.size());
  r.bounds = {Vec3::Zero(), Vec3::Zero()};
  if (!check_values(mesh, r)) return r;
  r = inspect_mesh(merge_equal_positions(mesh), "", options);
  r.format.clear();
  return r;
}

}  // namespace thigma
