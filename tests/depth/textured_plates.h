#pragma once
// Random textured patches and contacts between them; a slow depth to compare with.

#include <numeric>

#include "thigma/depth/depth_gradient.h"
#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma::test {

struct PlateShape {
  double size = 0.02;        // side [m]
  int cells = 2;             // quadrilaterals along each side
  int texels = 64;           // along each side
  double amplitude = 2e-4;   // of each of three waves [m]
  double bend = 1.0;         // curvature of the coarse surface [1/m]
  double noise = 0.0;        // of single texels, in any direction [m]
  double waves = 4.0;        // most periods along a side
  bool is_reversed = false;  // faces -z: the scene's side
};

inline TextureSource plate_source(Random& random, const PlateShape& s) {
  TextureSource source;
  source.width = source.height = s.texels;
  const int n = s.cells + 1;
  const double top = s.texels - 1.0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double x = s.size * (static_cast<double>(i) / s.cells - 0.5);
      const double y = s.size * (static_cast<double>(j) / s.cells - 0.5);
      const double z = 0.5 * s.bend * (s.is_reversed ? 1.0 : -1.0) * (x * x + y * y);
      source.coarse.positions.push_back({x, y, z});
    }
  }
  const auto add = [&](int a, int b, int c) {
    if (s.is_reversed) std::swap(b, c);
    source.coarse.triangles.push_back({a, b, c});
    std::array<Vec2, 3> corners;
    const int indices[] = {a, b, c};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = Vec2(indices[k] % n, indices[k] / n) * (top / s.cells);
    source.corners.push_back(corners);
  };
  for (int j = 0; j < s.cells; ++j) {
    for (int i = 0; i < s.cells; ++i) {
      const int a = j * n + i;
      add(a, a + 1, a + n + 1);
      add(a, a + n + 1, a + n);
    }
  }
  Vec3 wave[3];
  for (Vec3& w : wave)
    w = Vec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform());
  for (int j = 0; j < s.texels; ++j) {
    for (int i = 0; i < s.texels; ++i) {
      Vec3 d = s.noise * random.in_cube(1.0);
      for (const Vec3& w : wave)
        d.z() += s.amplitude *
                 sine(2.0 * kPi * (s.waves * (w.x() * i + w.y() * j) / std::max(top, 1.0) + w.z()));
      source.texels.push_back(
          {static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z())});
    }
  }
  return source;
}

/// Two plates that face each other, somewhere in the world, and the contact between them.
struct PlateContact {
  PlateContact(Random& random, PlateShape shape);
  PlateContact(const PlateContact&) = delete;  // `contact` points into it
  PlateContact& operator=(const PlateContact&) = delete;

  HapticTexture object, scene;
  std::vector<std::int32_t> object_triangles, scene_triangles;
  DepthContact contact;
};

inline std::vector<std::int32_t> all_triangles(const HapticTexture& texture) {
  std::vector<std::int32_t> list(texture.coarse.triangles.size());
  std::iota(list.begin(), list.end(), 0);
  return list;
}

/// Fills `contact` from the plates and two poses that put both about the origin; all of it is then
/// moved by `place`.
inline void place_contact(PlateContact& p, const Pose& object, const Pose& scene,
                          const Vec3& normal, const Pose& place) {
  p.object_triangles = all_triangles(p.object);
  p.scene_triangles = all_triangles(p.scene);
  p.contact.object = {&p.object, p.object_triangles, place * object};
  p.contact.scene = {&p.scene, p.scene_triangles, place * scene};
  p.contact.normal = place.orientation * normal;
  p.contact.point = place.position;
}

/// Moves the plates of a contact to another random relative pose.
inline void shuffle_contact(Random& random, PlateContact& p, double size) {
  const auto tilt = [&] { return rotation_from_vector(0.15 * random.in_cube(1.0)); };
  const Quat turn = rotation_from_vector(Vec3(0.0, 0.0, random.uniform(-3.0, 3.0)));
  const Pose object{
      Vec3(0.3 * size * random.uniform(-1.0, 1.0), 0.3 * size * random.uniform(-1.0, 1.0), 0.0),
      tilt() * turn};
  const Pose scene{Vec3::Zero(), tilt()};
  const Vec3 normal = (tilt() * Vec3::UnitZ()).normalized();
  const Pose place{random.in_cube(0.3), random.orientation()};
  place_contact(p, object, scene, normal, place);
  p.contact.centre = transform_point(place, Vec3(0.5 * size, -0.3 * size, -2.0 * size));
}

inline PlateContact::PlateContact(Random& random, PlateShape shape) {
  shape.is_reversed = false;
  object = make_texture(plate_source(random, shape), "object");
  shape.is_reversed = true;
  scene = make_texture(plate_source(random, shape), "scene");
  shuffle_contact(random, *this, shape.size);
}

/// Bilinear displacement, written down once more.
inline Vec3 lookup(const HapticTexture& texture, Vec2 at) {
  at = at.cwiseMax(0.0).cwiseMin(Vec2(texture.width - 1, texture.height - 1));
  const int i = static_cast<int>(std::floor(at.x())), j = static_cast<int>(std::floor(at.y()));
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 4; ++k) {
    const int column = std::min(i + k % 2, texture.width - 1),
              row = std::min(j + k / 2, texture.height - 1);
    const Texel& t = texture.texels[static_cast<std::size_t>(row * (texture.width + 1) + column)];
    const double weight =
        (k % 2 ? at.x() - i : 1.0 - at.x() + i) * (k / 2 ? at.y() - j : 1.0 - at.y() + j);
    sum += weight * Vec3(t.x, t.y, t.z);
  }
  return sum;
}

/// Barycentric coordinates of a point of a plane.
inline Vec3 barycentric(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  Eigen::Matrix2d edges;
  edges << b - a, c - a;
  const Vec2 xy = edges.inverse() * (p - a);
  return {1.0 - xy.sum(), xy.x(), xy.y()};
}

/// Which height over a point: of the fine point there, or to first order, as height maps hold it.
enum class SlowHeight { followed, of_maps };

/// A triangle of a patch in the world, seen along `direction` from the line through `at`.
struct SlowTriangle {
  Vec3 p[3];
  Vec2 q[3];
  std::array<Vec2, 3> corners;
  Vec3 rise;  // height of the triangle by a way across the direction
  bool faces = false;
  SlowTriangle(const TexturedPatch& patch, std::int32_t index, const Vec3& at, const Vec3& u,
               const Vec3& v, const Vec3& direction) {
    const HapticTexture& texture = *patch.texture;
    const std::size_t t = static_cast<std::size_t>(index);
    corners = texture.corners[t];
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = transform_point(
          patch.world_from_body,
          texture.coarse.positions[static_cast<std::size_t>(texture.coarse.triangles[t][k])]);
      q[k] = Vec2(u.dot(p[k] - at), v.dot(p[k] - at));
    }
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    faces = normal.dot(direction) > 0.0;
    rise = -(normal - direction.dot(normal) * direction) / normal.dot(direction);
  }
  Vec3 weights(const Vec2& place) const { return barycentric(q[0], q[1], q[2], place); }
  Vec3 coarse(const Vec3& w) const { return w[0] * p[0] + w[1] * p[1] + w[2] * p[2]; }
  Vec3 displacement(const TexturedPatch& patch, const Vec3& w) const {
    return patch.world_from_body.orientation *
           lookup(*patch.texture, w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2]);
  }
};

/// Largest height along `direction` (n or -n) over the point `at` of the line along it, by trying
/// all triangles [m]; kNoDepth where there is none.
inline double slow_height(const TexturedPatch& patch, const Vec3& at, const Vec3& u, const Vec3& v,
                          const Vec3& direction, SlowHeight kind = SlowHeight::followed) {
  double followed = kNoDepth, of_maps = kNoDepth;
  for (const std::int32_t index : patch.triangles) {
    const SlowTriangle t(patch, index, at, u, v, direction);
    if (!t.faces) continue;
    const Vec3 here = t.weights(Vec2::Zero());
    if (here.minCoeff() >= -1e-9) {
      const Vec3 d = t.displacement(patch, here), rise = t.rise / std::max(t.rise.norm(), 1.0);
      of_maps = std::max(of_maps, direction.dot(t.coarse(here) - at) + (direction - rise).dot(d));
    }
    // Back by what the displacement goes sideways, until the fine point lies over the place.
    Vec2 place = Vec2::Zero();
    Vec3 d = Vec3::Zero();
    for (int k = 0; k < 300; ++k) {
      Vec3 w = t.weights(place).cwiseMax(0.0);
      w /= w.sum();
      d = t.displacement(patch, w);
      place = -Vec2(u.dot(d), v.dot(d));
    }
    const Vec3 w = t.weights(place);
    if (w.minCoeff() >= -1e-9) followed = std::max(followed, direction.dot(t.coarse(w) + d - at));
  }
  return kind == SlowHeight::of_maps ? of_maps : followed;
}

/// Depth over the fine points of all texel centres of `driver` that lie over `other`.
inline double slow_depth_of(const TexturedPatch& driver, const TexturedPatch& other,
                            const DepthContact& contact, const Vec3& direction) {
  const ContactFrame frame = contact_frame(contact.point, contact.normal);
  const Vec3 u = frame.world_from_contact.col(0), v = frame.world_from_contact.col(1);
  const HapticTexture& texture = *driver.texture;
  double best = kNoDepth;
  for (const std::int32_t index : driver.triangles) {
    const std::size_t t = static_cast<std::size_t>(index);
    const std::array<Vec2, 3>& c = texture.corners[t];
    Vec3 p[3];
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = transform_point(
          driver.world_from_body,
          texture.coarse.positions[static_cast<std::size_t>(texture.coarse.triangles[t][k])]);
    }
    if (!((p[1] - p[0]).cross(p[2] - p[0]).dot(direction) > 0.0)) continue;
    for (int j = 0; j < texture.height; ++j) {
      for (int i = 0; i < texture.width; ++i) {
        const Vec3 w = barycentric(c[0], c[1], c[2], Vec2(i, j));
        if (w.minCoeff() < -1e-9) continue;
        const Vec3 coarse = w[0] * p[0] + w[1] * p[1] + w[2] * p[2];
        const Vec3 fine = coarse + driver.world_from_body.orientation * lookup(texture, Vec2(i, j));
        const Vec2 from(u.dot(fine - contact.point), v.dot(fine - contact.point));
        if (!(from.cwiseAbs().maxCoeff() <= contact.reach)) continue;
        best = std::max(best, slow_height(other, fine, u, v, -direction));
      }
    }
  }
  return best;
}

inline double slow_depth(const DepthContact& contact) {
  return std::max(slow_depth_of(contact.object, contact.scene, contact, contact.normal),
                  slow_depth_of(contact.scene, contact.object, contact, -contact.normal));
}

/// A flat plate with one round hill of this curvature [1/m].
inline TextureSource hill(double curvature, bool is_reversed) {
  Random random(1);
  TextureSource source =
      plate_source(random, {.cells = 1, .texels = 257, .bend = 0.0, .is_reversed = is_reversed});
  for (int j = 0; j < 257; ++j) {
    for (int i = 0; i < 257; ++i) {
      const double x = 0.02 * (i / 256.0 - 0.5), y = 0.02 * (j / 256.0 - 0.5);
      const float height =
          static_cast<float>(-0.5 * curvature * (x * x + y * y) * (is_reversed ? -1.0 : 1.0));
      source.texels[static_cast<std::size_t>(257 * j + i)] = {0.0f, 0.0f, height};
    }
  }
  return source;
}

/// Two hills that touch in one place, smoothly.
struct Hills {
  HapticTexture object = make_texture(hill(20.0, false), "object"),
                scene = make_texture(hill(30.0, true), "scene");
  std::vector<std::int32_t> triangles = all_triangles(object);
  DepthContact contact;
  Hills() {
    contact.object = {&object, triangles,
                      Pose{Vec3(4e-4, -7e-4, 1e-4), rotation_from_vector(Vec3(0.01, 0.02, 0.4))}};
    contact.scene = {&scene, triangles, Pose{}};
    contact.centre = Vec3(0.01, -0.02, -0.05);
    contact.point = Vec3(1e-4, 0.0, 0.0);
  }
};

/// The contact after a motion of the object: a way, and a rotation vector about the contact's
/// centre, which stays.
inline DepthContact moved(const DepthContact& contact, const Vec6& by) {
  DepthContact there = contact;
  Pose motion;
  motion.orientation = rotation_from_vector(by.tail<3>());
  motion.position =
      by.head<3>() + contact.centre - motion.orientation._transformVector(contact.centre);
  there.object.world_from_body = motion * contact.object.world_from_body;
  return there;
}

inline Vec6 six(const DepthGradient& g) {
  Vec6 v;
  v << g.linear, g.angular;
  return v;
}

/// The answer for one contact.
inline DepthSamples depth_of(DepthBackend& backend, const DepthContact& contact,
                             const DepthRequest& request = {}) {
  DepthSamples sample;
  backend.sample({&contact, 1}, request, {&sample, 1});
  return sample;
}

}  // namespace thigma::test
