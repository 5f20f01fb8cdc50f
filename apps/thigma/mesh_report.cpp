#include "mesh_report.h"

#include <sstream>

#include "number_text.h"

namespace thigma::app {
namespace {

using nlohmann::ordered_json;

ordered_json vector_json(const Vec3& v) { return ordered_json::array({v.x(), v.y(), v.z()}); }

ordered_json matrix_json(const Mat3& m) {
  ordered_json rows = ordered_json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(ordered_json::array({m(i, 0), m(i, 1), m(i, 2)}));
  return rows;
}

template <class T>
ordered_json or_null(const std::optional<T>& value, ordered_json (*convert)(const T&)) {
  return value ? convert(*value) : ordered_json(nullptr);
}

}  // namespace

ordered_json mesh_report_json(const MeshReport& r) {
  ordered_json j;
  j["file"] = r.file;
  j["format"] = r.format;
  j["triangles"] = r.triangles;
  j["vertices"] = r.vertices;
  j["vertices_in_file"] = r.vertices_in_file;
  j["triangles_left_out"] = r.triangles_left_out;
  j["components"] = r.components;
  j["boundary_edges"] = r.boundary_edges;
  j["nonmanifold_edges"] = r.nonmanifold_edges;
  j["nonmanifold_vertices"] = r.nonmanifold_vertices;
  j["misoriented_edges"] = r.misoriented_edges;
  j["degenerate_triangles"] = r.degenerate_triangles;
  j["duplicate_triangles"] = r.duplicate_triangles;
  j["self_intersections"] = r.self_intersections;
  j["self_intersections_complete"] = r.self_intersections_counted;
  j["unwelded_vertices"] = r.unwelded_vertices;
  j["inside_out_components"] = r.inside_out_components;
  j["nonorientable_components"] = r.nonorientable_components;
  j["zero_volume_components"] = r.zero_volume_components;
  j["closed"] = r.closed;
  j["manifold"] = r.manifold;
  j["oriented"] = r.oriented;
  j["area"] = r.area;
  j["volume"] = r.volume ? ordered_json(*r.volume) : ordered_json(nullptr);
  j["center_of_mass"] = or_null<Vec3>(r.center_of_mass, vector_json);
  j["inertia"] = or_null<Mat3>(r.inertia, matrix_json);
  j["radius"] = r.radius;
  j["bounds"] = {{"min", vector_json(r.bounds.min)}, {"max", vector_json(r.bounds.max)}};
  j["verdict"] = verdict_name(r.verdict);
  j["reasons"] = r.reasons;
  j["warnings"] = r.warnings;
  return j;
}

std::string mesh_report_text(const MeshReport& r) {
  std::ostringstream out;
  const Vec3 extent = r.bounds.max - r.bounds.min;
  out << r.file << ": " << verdict_name(r.verdict) << " (" << r.format << ")\n"
      << "  triangles " << r.triangles << ", vertices " << r.vertices << " (" << r.vertices_in_file
      << " in the file), components " << r.components << '\n'
      << "  " << (r.closed ? "closed" : "open") << ", "
      << (r.manifold ? "manifold" : "not manifold") << ", "
      << (r.oriented ? "oriented" : "not oriented") << "; boundary edges " << r.boundary_edges
      << ", self-intersections " << r.self_intersections << ", zero-area triangles "
      << r.degenerate_triangles << '\n'
      << "  extent " << with_unit(extent.x(), "m") << " x " << with_unit(extent.y(), "m") << " x "
      << with_unit(extent.z(), "m") << ", radius " << with_unit(r.radius, "m") << ", area "
      << three_digits(r.area) << " m^2";
  if (r.volume) out << ", volume " << three_digits(*r.volume) << " m^3";
  out << '\n';
  for (const std::string& reason : r.reasons) out << "  reason: " << reason << '\n';
  for (const std::string& warning : r.warnings) out << "  warning: " << warning << '\n';
  return out.str();
}

std::vector<std::string> ways_on(const MeshReport& report, const TriangleMesh& mesh) {
  if (report.verdict == MeshVerdict::usable) return {};
  if (report.verdict == MeshVerdict::repairable) return {"repair"};
  std::vector<std::string> ways;
  if (report.components > 1) {
    const InspectOptions quick{.self_intersections = false};
    const MeshReport alone = inspect_mesh(keep_largest_component(mesh).mesh, quick);
    if (alone.verdict != MeshVerdict::rejected) ways.emplace_back("repair --largest");
  }
  if (can_wrap(report)) ways.emplace_back("repair --shell");
  return ways;
}

}  // namespace thigma::app
