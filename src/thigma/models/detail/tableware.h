#pragma once
// Cup with a handle and spoon.

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::models {

/// Cup: 11 cm high, standing on z = 0 about the z axis, its handle towards +x; fits a ball of 8 cm.
/// Genus 1, [m].
TriangleMesh make_cup(int triangles);

/// Spoon: 20 cm along x from the bowl's tip at x = 0, the bowl open towards +z with its rim near z
/// = 0. Genus 0, [m].
TriangleMesh make_spoon(int triangles);

/// A point in the opening of the cup's handle, and where along x the spoon's neck is: to thread one
/// into the other.
Vec3 cup_handle_opening();
double spoon_neck();

}  // namespace thigma::models
