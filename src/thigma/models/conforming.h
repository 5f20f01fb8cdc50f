#pragma once
// Pairs whose surfaces fit each other over a wide area: the ball joint and two wavy discs.

#include <cstdint>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::models {

inline constexpr double kJointRadius = 0.025;  // of the ball [m]
// between ball and socket, without their relief [m]
inline constexpr double kJointClearance = 0.0005;
inline constexpr double kConformingGap = 1e-4;  // between the wavy discs, upwards [m]

/// Ball with a stem up +z, and the socket that holds its lower part; both centred in the ball, in
/// one frame, both with a fine relief. Closed, genus 0, [m].
TriangleMesh make_joint_ball(int triangles, std::uint64_t seed);
TriangleMesh make_joint_socket(int triangles, std::uint64_t seed);

/// Discs of 100 mm radius, z up. The top of the lower one and the underside of the upper one follow
/// the same waves, kConformingGap apart (from about 20,000 triangles on; fewer follow them too
/// coarsely). Nine tenths of the triangles are on the wavy sides. Closed, genus 0, [m].
TriangleMesh make_conforming_lower(int triangles, std::uint64_t seed);
TriangleMesh make_conforming_upper(int triangles, std::uint64_t seed);

}  // namespace thigma::models
