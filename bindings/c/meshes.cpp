// Meshes and levels of detail.

#include <algorithm>
#include <thread>

#include "guard.h"
#include "handles.h"
#include "mesh_arrays.h"

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/clod_file.h"
#include "thigma/core/error.h"

namespace {

using namespace thigma;

ClodAsset exact(const TriangleMesh& surface) {
  ClodAsset asset;
  asset.hierarchy = build_exact_hierarchy(surface);
  return asset;
}

thigma_clod* make_clod(ClodAsset&& asset) {
  return new thigma_clod{std::make_shared<const ClodAsset>(std::move(asset))};
}

void check_count(std::int64_t count, std::int64_t most, const char* name) {
  if (count < 0 || count > most) {
    throw std::invalid_argument(std::string(name) + ": " + std::to_string(count) +
                                ", expected 0 to " + std::to_string(most));
  }
}

}  // namespace

extern "C" {

thigma_result thigma_mesh_create(const double* vertices, int64_t vertex_count,
                                 const int32_t* triangles, int64_t triangle_count, double scale,
                                 thigma_mesh** mesh) {
  return c::guarded([&] {
    c::needed(mesh, "mesh");
    check_count(vertex_count, INT32_MAX, "vertex_count");
    check_count(triangle_count, INT32_MAX, "triangle_count");
    if (vertex_count > 0) c::needed(vertices, "vertices");
    if (triangle_count > 0) c::needed(triangles, "triangles");
    const bindings::MeshArrays arrays{vertices, vertex_count, triangles, triangle_count};
    *mesh = new thigma_mesh{bindings::usable_mesh(arrays, {.scale = scale})};
  });
}

thigma_result thigma_mesh_load(const char* path, double scale, thigma_mesh** mesh) {
  return c::guarded([&] {
    c::needed(mesh, "mesh");
    c::needed(path, "path");
    *mesh = new thigma_mesh{bindings::usable_mesh(path, {.scale = scale})};
  });
}

void thigma_mesh_free(thigma_mesh* mesh) { delete mesh; }

int64_t thigma_mesh_vertex_count(const thigma_mesh* mesh) {
  return mesh == nullptr ? 0 : static_cast<int64_t>(mesh->surface.positions.size());
}

int64_t thigma_mesh_triangle_count(const thigma_mesh* mesh) {
  return mesh == nullptr ? 0 : static_cast<int64_t>(mesh->surface.triangles.size());
}

const double* thigma_mesh_vertices(const thigma_mesh* mesh) {
  return mesh == nullptr ? nullptr : mesh->surface.positions.front().data();
}

const int32_t* thigma_mesh_triangles(const thigma_mesh* mesh) {
  return mesh == nullptr ? nullptr : mesh->surface.triangles.front().data();
}

thigma_result thigma_clod_exact(const thigma_mesh* mesh, thigma_clod** clod) {
  return c::guarded([&] {
    c::needed(clod, "clod");
    *clod = make_clod(exact(c::needed(mesh, "mesh").surface));
  });
}

thigma_result thigma_clod_build(const thigma_mesh* mesh, int32_t threads, thigma_clod** clod) {
  return c::guarded([&] {
    c::needed(clod, "clod");
    check_count(threads, 256, "threads");
    ClodParams params;
    const auto hardware = static_cast<int>(std::thread::hardware_concurrency());
    params.threads = threads > 0 ? threads : std::clamp(hardware, 1, 256);
    *clod = make_clod(build_clod_asset(c::needed(mesh, "mesh").surface, params));
  });
}

thigma_result thigma_clod_load(const char* path, double scale, thigma_clod** clod) {
  return c::guarded([&] {
    c::needed(clod, "clod");
    ClodAsset asset = read_clod(&c::needed(path, "path"));
    scale_clod(asset, scale, path);
    *clod = make_clod(std::move(asset));
  });
}

thigma_result thigma_clod_save(const thigma_clod* clod, const char* path) {
  return c::guarded([&] { write_clod(*c::needed(clod, "clod").asset, &c::needed(path, "path")); });
}

void thigma_clod_free(thigma_clod* clod) { delete clod; }

double thigma_clod_radius(const thigma_clod* clod) {
  return clod == nullptr ? 0.0 : clod->asset->hierarchy.radius;
}

int32_t thigma_clod_level_count(const thigma_clod* clod) {
  return clod == nullptr ? 0 : static_cast<int32_t>(clod->asset->meshes.size());
}

}  // extern "C"
