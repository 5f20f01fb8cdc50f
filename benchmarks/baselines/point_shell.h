#pragma once
// The strongest practical competitor: points of each surface in a tree of spheres, tested against a
// distance field of the other (after McNeely, Puterbaugh and Troy 1999; Barbic and James 2008).

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "benchmarks/baselines/distance_field.h"

#include "thigma/math/pose.h"

namespace thigma::bench {

struct ShellParams {
  FieldParams field;
  double spacing = 0.0;  // longer edges get points between their ends, and larger triangles inside,
                         // no farther apart than this [m]; 0: the vertices alone
};

/// Up to eight points of a shell, side by side.
struct ShellLeaf {
  std::array<float, 8> x{}, y{}, z{};   // [m; mesh frame]; the last is repeated
  std::array<std::int32_t, 8> point{};  // into PointShell::normals
  std::int32_t count = 0;
};

/// Up to four spheres of the tree, side by side: each holds all points below it.
struct ShellNode {
  std::array<float, 4> x{}, y{}, z{}, radius{};  // [m; mesh frame]; the last is repeated
  std::array<std::int32_t, 4> child{};           // a node, or -1 - a leaf
  std::int32_t count = 0;
};

/// Points with normals of a surface, and the field of its inside.
struct PointShell {
  std::vector<ShellNode> nodes;  // 0 is the root
  std::vector<ShellLeaf> leaves;
  std::vector<std::array<float, 3>> normals;  // outwards, unit; the mesh's vertices come first
  DistanceField field;
};

/// Shell of a closed, oriented mesh. Thread [offline]; deterministic; throws std::bad_alloc.
PointShell build_point_shell(const TriangleMesh& mesh, const ShellParams& params = {});

/// Bytes of tree, points and field.
std::size_t shell_bytes(const PointShell& shell);

/// A point of one object within the tolerance of the other.
struct ShellContact {
  Vec3 point = Vec3::Zero();    // [m; world]
  Vec3 normal = Vec3::UnitZ();  // unit, out of the grasped object, into the scene [world]
  double depth = 0.0;           // minus the distance to the other surface [m]
  std::int32_t index = -1;      // of the point, in its shell
  bool is_of_object = false;    // whose point it is
};

/// Counts of one query.
struct ShellStats {
  std::int64_t spheres = 0, points = 0;  // tested
};

/// Every point of either object nearer than the tolerance to the other, or inside it, up to the
/// error of the fields. A point deeper than the field's band has the depth of its brick's centre
/// and its own normal. contacts: emptied first; grows. Thread: any; allocates only to grow.
ShellStats query_shells(const PointShell& object, const Pose& world_from_object,
                        const PointShell& scene, const Pose& world_from_scene, double tolerance,
                        std::vector<ShellContact>& contacts);

/// The points of `shell` against the field of `other` alone.
ShellStats query_one_way(const PointShell& shell, const Pose& world_from_shell,
                         const PointShell& other, const Pose& world_from_other, double tolerance,
                         bool is_of_object, std::vector<ShellContact>& contacts);

}  // namespace thigma::bench
