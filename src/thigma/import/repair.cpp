#include "thigma/import/repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "thigma/core/error.h"
#include "thigma/import/duplicates.h"
#include "thigma/import/inspect.h"
#include "thigma/import/weld.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

using Triangle = std::array<std::int32_t, 3>;

// How far a vertex taken apart moves into its fan, times the radius: enough to stay apart in single
// precision too.
constexpr double kSplitDistance = 1e-6;
// And at most this fraction of its fan's shortest edge.
constexpr double kSplitEdgeFraction = 0.05;

constexpr int kMaxRounds = 4;  // one repair can uncover another; none was seen to need three

struct Repair {
  TriangleMesh mesh;
  double radius = 0.0;
  std::vector<std::string> done;
  std::vector<std::int64_t> votes = {};  // of each triangle, for being the right way round

  const Vec3& at(std::int32_t v) const { return mesh.positions[static_cast<std::size_t>(v)]; }
  void note(std::int64_t count, const char* one, const char* many) {
    if (count > 0) done.push_back(std::to_string(count) + ' ' + (count == 1 ? one : many));
  }
};

void weld(Repair& repair) {
  const Welds welds = find_welds(repair.mesh, build_edge_table(repair.mesh), repair.radius);
  if (welds.count == 0) return;
  std::vector<Triangle> kept;
  for (const Triangle& t : repair.mesh.triangles) {
    Triangle w{};
    for (std::size_t k = 0; k < 3; ++k) w[k] = welds.target[static_cast<std::size_t>(t[k])];
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) kept.push_back(w);
  }
  repair.mesh.triangles = std::move(kept);
  repair.note(welds.count, "vertex welded to one that nearly equals it",
              "vertices welded to ones that nearly equal them");
}

// Fins go, and one of each group of equal triangles stays. Which way round is decided by its
// neighbours: the triangles that the mesh has once, before those that turn one way more often than
// the other.
void drop_duplicates(Repair& repair) {
  const DistinctFaces faces = list_distinct_faces(repair.mesh);
  const std::vector<bool> is_fin = find_fins(repair.mesh, faces);
  const auto all = static_cast<std::int64_t>(repair.mesh.triangles.size());
  std::vector<Triangle> kept;
  repair.votes.clear();
  for (std::size_t i = 0; i < faces.triangle.size(); ++i) {
    if (is_fin[i]) continue;
    kept.push_back(repair.mesh.triangles[static_cast<std::size_t>(faces.triangle[i])]);
    const std::int64_t net = faces.net[i];
    repair.votes.push_back(faces.copies[i] == 1 ? all + 1 : std::clamp<std::int64_t>(net, -1, 1));
  }
  const std::int64_t dropped = all - static_cast<std::int64_t>(kept.size());
  if (dropped == 0) return;
  repair.mesh.triangles = std::move(kept);
  repair.note(dropped, "duplicate triangle dropped", "duplicate triangles dropped");
}

void orient(Repair& repair) {
  const Orientation o = orient_sheets(repair.mesh, build_edge_table(repair.mesh));
  // For the turning as it is, by sheet.
  std::vector<std::int64_t> votes(static_cast<std::size_t>(o.sheets), 0);
  const auto sheet_of = [&](std::size_t t) {
    return static_cast<std::size_t>(o.sheet_of_triangle[t]);
  };
  for (std::size_t t = 0; t < repair.mesh.triangles.size(); ++t)
    votes[sheet_of(t)] += o.is_flipped[t] ? -repair.votes[t] : repair.votes[t];
  std::int64_t turned = 0;
  for (std::size_t t = 0; t < repair.mesh.triangles.size(); ++t) {
    if (o.is_flipped[t] == (votes[sheet_of(t)] < 0)) continue;
    std::swap(repair.mesh.triangles[t][1], repair.mesh.triangles[t][2]);
    ++turned;
  }
  repair.note(turned, "triangle turned over to agree with its neighbours",
              "triangles turned over to agree with their neighbours");
}

// Angle of a face around the edge a b, seen along it; only the order counts.
double angle_around(const Repair& repair, const MeshEdge& e, const EdgeUse& use) {
  const Vec3 axis = (repair.at(e.b) - repair.at(e.a)).normalized();
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vec3 x = axis.cross(Vec3::Unit(least)).normalized();
  const Vec3 y = axis.cross(x);
  const std::int32_t tip = repair.mesh.triangles[static_cast<std::size_t>(use.triangle)]
                                                [static_cast<std::size_t>((use.corner + 2) % 3)];
  const Vec3 to_tip = (repair.at(tip) - repair.at(e.a)) / repair.radius;
  return arc_tangent2(to_tip.dot(y), to_tip.dot(x));
}

using AngledUse = std::pair<double, EdgeUse>;

// Takes pairs of neighbours that enclose solid between them out of the faces around an edge. Seen
// along the edge, a face that runs backward has the solid on its counter-clockwise side, one that
// runs forward on the other.
void take_pairs(std::vector<AngledUse>& around, std::vector<UsePair>& links) {
  // As brackets: each forward one closes the last backward one that is still open.
  std::vector<AngledUse> open, unopened;
  for (const AngledUse& use : around) {
    if (!use.second.is_forward) {
      open.push_back(use);
    } else if (open.empty()) {
      unopened.push_back(use);
    } else {
      links.push_back({open.back().second, use.second});
      open.pop_back();
    }
  }
  // After the last one comes the first.
  std::size_t first = 0;
  for (; !open.empty() && first < unopened.size(); ++first) {
    links.push_back({open.back().second, unopened[first].second});
    open.pop_back();
  }
  around.assign(unopened.begin() + static_cast<std::ptrdiff_t>(first), unopened.end());
  around.insert(around.end(), open.begin(), open.end());
}

// What belongs together around the edges: faces in pairs, and at edges of three or more faces some
// alone.
struct FaceLinks {
  std::vector<UsePair> pairs;
  std::vector<EdgeUse> alone;
  std::int64_t split_edges = 0;
};

FaceLinks link_faces(const Repair& repair, const EdgeTable& table) {
  FaceLinks links;
  const auto is_flap = [&](const EdgeUse& use) {
    const std::array<std::int32_t, 3>& edges =
        table.of_triangle[static_cast<std::size_t>(use.triangle)];
    return std::any_of(edges.begin(), edges.end(), [&](std::int32_t e) {
      return table.edges[static_cast<std::size_t>(e)].use_count == 1;
    });
  };
  for (const MeshEdge& e : table.edges) {
    const std::span<const EdgeUse> uses = table.uses_of(e);
    if (uses.size() == 2) links.pairs.push_back({uses[0], uses[1]});
    if (uses.size() <= 2) continue;
    ++links.split_edges;
    // Surfaces that go on come first: a flap inside a solid must not tear its shell open.
    std::vector<AngledUse> whole, flaps;
    for (const EdgeUse& use : uses)
      (is_flap(use) ? flaps : whole).emplace_back(angle_around(repair, e, use), use);
    const auto by_angle = [](const AngledUse& a, const AngledUse& b) { return a.first < b.first; };
    std::stable_sort(whole.begin(), whole.end(), by_angle);
    take_pairs(whole, links.pairs);
    whole.insert(whole.end(), flaps.begin(), flaps.end());
    std::stable_sort(whole.begin(), whole.end(), by_angle);
    take_pairs(whole, links.pairs);
    for (const AngledUse& left : whole) links.alone.push_back(left.second);
  }
  return links;
}

// Gives the faces along one edge a vertex of their own in its middle, a little towards their other
// corners.
void cut_at_middle(Repair& repair, std::span<const EdgeUse> uses) {
  const std::int32_t middle = static_cast<std::int32_t>(repair.mesh.positions.size());
  Vec3 on_edge = Vec3::Zero(), tips = Vec3::Zero();
  for (const EdgeUse& u : uses) {
    Triangle& t = repair.mesh.triangles[static_cast<std::size_t>(u.triangle)];
    const std::size_t k = static_cast<std::size_t>(u.corner);
    on_edge = 0.5 * repair.at(t[k]) + 0.5 * repair.at(t[(k + 1) % 3]);
    tips += repair.at(t[(k + 2) % 3]) / static_cast<double>(uses.size());
    Triangle other = t;
    t[(k + 1) % 3] = middle;
    other[k] = middle;
    repair.mesh.triangles.push_back(other);
  }
  const Vec3 inward = tips - on_edge;
  const double length = inward.norm();
  const double move = std::min(kSplitDistance * repair.radius, kSplitEdgeFraction * length);
  repair.mesh.positions.push_back(length > 0.0 ? Vec3(on_edge + inward * (move / length))
                                               : on_edge);
}

// Faces that would keep both ends of their edge in common with others along it are cut. (A surface
// that touches itself along one edge and is whole around both ends of it.) False when there are
// none.
bool cut_shared_edges(Repair& repair, const EdgeTable& table, const FaceLinks& links,
                      const Fans& fans) {
  struct Group {
    std::int32_t fan_a, fan_b;  // at the ends of the edge
    std::array<EdgeUse, 2> uses;
    std::size_t count;
  };
  std::vector<Group> groups;
  const auto add = [&](const std::array<EdgeUse, 2>& uses, std::size_t count) {
    const EdgeUse& u = uses[0];
    const std::int32_t e =
        table.of_triangle[static_cast<std::size_t>(u.triangle)][static_cast<std::size_t>(u.corner)];
    if (table.edges[static_cast<std::size_t>(e)].use_count <= 2) return;
    const auto fan = [&](int step) {
      return fans.of_corner[static_cast<std::size_t>(3 * u.triangle + (u.corner + step) % 3)];
    };
    groups.push_back({fan(u.is_forward ? 0 : 1), fan(u.is_forward ? 1 : 0), uses, count});
  };
  for (const UsePair& pair : links.pairs) add(pair, 2);
  for (const EdgeUse& use : links.alone) add({use, use}, 1);
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return a.fan_a < b.fan_a || (a.fan_a == b.fan_a && a.fan_b < b.fan_b);
  });
  std::vector<bool> is_cut(repair.mesh.triangles.size(),
                           false);  // once a round: its corners have moved
  bool any = false;
  for (std::size_t i = 1; i < groups.size(); ++i) {
    if (groups[i].fan_a != groups[i - 1].fan_a || groups[i].fan_b != groups[i - 1].fan_b) continue;
    const std::span<const EdgeUse> uses(groups[i].uses.data(), groups[i].count);
    any = true;
    const bool may_cut = std::none_of(uses.begin(), uses.end(), [&](const EdgeUse& u) {
      return is_cut[static_cast<std::size_t>(u.triangle)];
    });
    if (!may_cut) continue;
    for (const EdgeUse& u : uses) is_cut[static_cast<std::size_t>(u.triangle)] = true;
    cut_at_middle(repair, uses);
  }
  return any;
}

// Every fan gets a vertex of its own; all but the first at a vertex move a little towards their own
// faces.
std::int64_t split_vertices(Repair& repair, const Fans& fans) {
  std::vector<std::int32_t> vertex_of_fan(static_cast<std::size_t>(fans.count), -1);
  std::vector<Vec3> middle(static_cast<std::size_t>(fans.count), Vec3::Zero());
  std::vector<double> weight(static_cast<std::size_t>(fans.count), 0.0);
  std::vector<double> shortest(static_cast<std::size_t>(fans.count),
                               std::numeric_limits<double>::infinity());
  std::vector<bool> is_taken(repair.mesh.positions.size(), false);
  std::vector<std::int32_t> moved;
  const std::vector<Triangle> before = repair.mesh.triangles;
  for (std::size_t c = 0; c < fans.of_corner.size(); ++c) {
    const std::size_t fan = static_cast<std::size_t>(fans.of_corner[c]);
    const Triangle& t = before[c / 3];
    const std::int32_t v = t[c % 3];
    const Vec3 others[2] = {repair.at(t[(c % 3 + 1) % 3]) - repair.at(v),
                            repair.at(t[(c % 3 + 2) % 3]) - repair.at(v)};
    for (const Vec3& o : others) {
      middle[fan] += o;
      weight[fan] += 1.0;
      shortest[fan] = std::min(shortest[fan], o.norm());
    }
    if (vertex_of_fan[fan] < 0) {
      vertex_of_fan[fan] = v;
      if (is_taken[static_cast<std::size_t>(v)]) {
        vertex_of_fan[fan] = static_cast<std::int32_t>(repair.mesh.positions.size());
        repair.mesh.positions.push_back(Vec3(repair.at(v)));
        moved.push_back(static_cast<std::int32_t>(fan));
      } else {
        is_taken[static_cast<std::size_t>(v)] = true;
      }
    }
    repair.mesh.triangles[c / 3][c % 3] = vertex_of_fan[fan];
  }
  for (const std::int32_t f : moved) {
    const std::size_t fan = static_cast<std::size_t>(f);
    const Vec3 inward = middle[fan] / weight[fan];
    const double length = inward.norm();
    const double move =
        std::min(kSplitDistance * repair.radius, kSplitEdgeFraction * shortest[fan]);
    if (length > 0.0)
      repair.mesh.positions[static_cast<std::size_t>(vertex_of_fan[fan])] +=
          inward * (move / length);
  }
  return static_cast<std::int64_t>(moved.size());
}

void take_apart(Repair& repair) {
  const EdgeTable table = build_edge_table(repair.mesh);
  const FaceLinks links = link_faces(repair, table);
  const Fans fans = build_fans(repair.mesh, links.pairs);
  repair.note(links.split_edges, "edge with three or more faces taken apart",
              "edges with three or more faces taken apart");
  // After a cut the next round splits the vertices of the new surface.
  if (cut_shared_edges(repair, table, links, fans)) return;
  repair.note(split_vertices(repair, fans), "vertex added where fans of faces met in one point",
              "vertices added where fans of faces met in one point");
}

void turn_outwards(Repair& repair) {
  const std::vector<std::int32_t> inside_out = find_inside_out_components(repair.mesh);
  const Components c = connect_over_edges(repair.mesh, build_edge_table(repair.mesh));
  for (std::size_t t = 0; t < repair.mesh.triangles.size(); ++t) {
    if (std::binary_search(inside_out.begin(), inside_out.end(), c.of_triangle[t])) {
      std::swap(repair.mesh.triangles[t][1], repair.mesh.triangles[t][2]);
    }
  }
  repair.note(static_cast<std::int64_t>(inside_out.size()), "closed component turned outwards",
              "closed components turned outwards");
}

[[noreturn]] void fail(const std::string& name, const MeshReport& report, const char* what) {
  throw InputError(name + ": " + report.reasons.front() + what);
}

}  // namespace

RepairResult repair_mesh(const TriangleMesh& mesh, const std::string& name) {
  const InspectOptions quick{.self_intersections = false};
  MeshReport report = inspect_mesh(mesh, quick);
  if (report.verdict == MeshVerdict::rejected) {
    fail(name, report, ", in the mesh as a whole, expected a mesh that can be repaired");
  }
  Repair repair{mesh, report.radius, {}};
  for (int round = 0; round < kMaxRounds && report.verdict == MeshVerdict::repairable; ++round) {
    repair.mesh = merge_equal_positions(std::move(repair.mesh)).mesh;
    weld(repair);
    drop_duplicates(repair);
    orient(repair);
    take_apart(repair);
    turn_outwards(repair);
    repair.mesh = merge_equal_positions(std::move(repair.mesh)).mesh;
    report = inspect_mesh(repair.mesh, quick);
  }
  if (report.verdict != MeshVerdict::usable)
    fail(name, report,
         " after repair, in the mesh as a whole, expected to be able to repair it; `thigma repair "
         "--shell` wraps it");
  return {std::move(repair.mesh), std::move(repair.done)};
}

}  // namespace thigma
