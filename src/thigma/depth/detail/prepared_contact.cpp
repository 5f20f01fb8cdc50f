#include "thigma/depth/detail/prepared_contact.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/plane_cross.h"

namespace thigma::detail {
namespace {

bool is_usable(const TexturedPatch& patch) noexcept {
  // Squares of what is computed with these have to stay numbers.
  constexpr double kFarthest = 1e100;
  const Vec3& p = patch.world_from_body.position;
  return patch.texture && (p.array().abs() < kFarthest).all() &&
         patch.world_from_body.orientation.coeffs().allFinite();
}

bool is_direction(const Vec3& v) noexcept {
  const double square = v.squaredNorm();
  return square > 0.5 && square < 2.0;
}

double relief_texel(const HapticTexture& texture) noexcept {
  return texture.amplitude > 0.0 ? texture.texel_size : std::numeric_limits<double>::infinity();
}

constexpr double kNearEdge = 2.0;  // of a step: edges farther away do not cut what lies around

// A point of the plane, how deep it is there, and on which triangles.
struct Place {
  Vec2 at = Vec2::Zero();
  double depth = kNoDepth;
  NearTriangles triangles;
};

// The deepest place found around one, and whether some of them lay on other triangles or on none.
struct Surroundings {
  Place best;
  bool is_cut = false;
};

void try_point(const PreparedContact& prepared, const Place& from, const Vec2& point,
               Surroundings& around) noexcept {
  Place to{point.cwiseMax(prepared.box.low).cwiseMin(prepared.box.high), kNoDepth, from.triangles};
  to.depth = depth_at(prepared, to.at, to.triangles);
  around.is_cut = around.is_cut || to.depth == kNoDepth ||
                  to.triangles.object != from.triangles.object ||
                  to.triangles.scene != from.triangles.scene;
  if (to.depth > around.best.depth) around.best = to;
}

// Eight steps along the axes and diagonals.
Surroundings look_around(const PreparedContact& prepared, const Place& from,
                         const Vec2& step) noexcept {
  Surroundings around{from, false};
  for (int i = 0; i < 9; ++i) {
    if (i == 4) continue;
    try_point(prepared, from, from.at + step.cwiseProduct(Vec2(i % 3 - 1, i / 3 - 1)), around);
  }
  return around;
}

// Steps to and fro parallel to the edges of the triangles it lies on, those that a step may reach.
Place look_along_edges(const PreparedContact& prepared, const Place& from, double length) noexcept {
  Surroundings around{from, false};
  const auto try_edges = [&](const ProjectedPatch& patch, std::int32_t triangle, const Vec2& at) {
    if (triangle < 0) return;
    const ProjectedTriangle& t = projected_triangle(patch, triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& edge = t.edges[k];
      // By as much as its points move sideways the fine surface may end beside the edge.
      const double far = cross(edge, at - t.at[k]) + t.least[k];
      if (far > kNearEdge * length * edge.norm()) continue;
      const Vec2 step = length * edge.normalized();
      try_point(prepared, from, from.at + step, around);
      try_point(prepared, from, from.at - step, around);
    }
  };
  try_edges(prepared.object, from.triangles.object, from.at - prepared.shift);
  try_edges(prepared.scene, from.triangles.scene, from.at);
  return around.best;
}

}  // namespace

void project_sides(const DepthContact& contact, const ContactFrame& frame, const PlaneBox& over,
                   ProjectedPatch& object, ProjectedPatch& scene) noexcept {
  project_patch(contact.object, frame, Facing::along, object, over);
  project_patch(contact.scene, frame, Facing::against, scene, over);
}

double finer_texel(const DepthContact& contact) noexcept {
  return std::min(contact.object.texture->texel_size, contact.scene.texture->texel_size);
}

bool prepare_contact(const DepthContact& contact, PreparedContact& prepared) noexcept {
  if (!is_usable(contact.object) || !is_usable(contact.scene)) return false;
  if (!contact.point.allFinite() || !contact.centre.allFinite()) return false;
  if (!is_direction(contact.normal)) return false;
  prepared.frame = contact_frame(contact.point, contact.normal);
  prepared.shift.setZero();
  prepared.start = {};
  project_sides(contact, prepared.frame, kWholePlane, prepared.object, prepared.scene);
  const Vec2 reach = Vec2::Constant(contact.reach);
  prepared.box =
      intersection(intersection(prepared.object.box, prepared.scene.box), {-reach, reach});
  if (prepared.box.is_empty()) return false;
  const double texel =
      std::min(relief_texel(*contact.object.texture), relief_texel(*contact.scene.texture));
  // no relief: a corner of one side may be the deepest place
  prepared.texel = std::isfinite(texel) ? texel : 0.0;
  return true;
}

void project_moved(const DepthContact& contact, const Pose& motion,
                   PreparedContact& prepared) noexcept {
  project_patch(
      {contact.object.texture, contact.object.triangles, motion * contact.object.world_from_body},
      prepared.frame, Facing::along, prepared.object);
}

double depth_at(const PreparedContact& prepared, const Vec2& at, NearTriangles& near) noexcept {
  const double object = height_at(prepared.object, at - prepared.shift, near.object);
  if (object == kNoSurface) return kNoDepth;
  return object + height_at(prepared.scene, at, near.scene);
}

double climb(const PreparedContact& prepared, const Vec2& spacing, Vec2& at) noexcept {
  constexpr int kMostHalvings = 24;
  constexpr int kMostMoves = 32;  // along edges, all together
  Place here{at, kNoDepth, prepared.start};
  here.depth = depth_at(prepared, at, here.triangles);
  Vec2 step = spacing;
  int moves = 0;
  for (int k = 0; k < kMostHalvings && step.minCoeff() > prepared.finest * prepared.texel; ++k) {
    step *= 0.5;
    const Surroundings around = look_around(prepared, here, step);
    here = around.best;
    // On a slanting edge, of the domain or of a fold, steps along the axes lose more than they gain
    // along it.
    while (around.is_cut && moves < kMostMoves) {
      const Place along = look_along_edges(prepared, here, step.norm());
      if (!(along.depth > here.depth)) break;
      here = along;
      ++moves;
    }
  }
  at = here.at;
  return here.depth;
}

bool is_upright(const PreparedContact& prepared, const Vec2& at) noexcept {
  const auto is_one = [&](const ProjectedPatch& patch) {
    const SurfaceJet jet = surface_jet(patch, at);
    return jet.is_height_field && !is_overhung(patch, at, jet.height, prepared.texel);
  };
  return is_one(prepared.object) && is_one(prepared.scene);
}

}  // namespace thigma::detail
