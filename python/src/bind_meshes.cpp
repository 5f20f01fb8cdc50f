// Meshes and levels of detail.

#include <algorithm>
#include <cmath>
#include <thread>

#include "bind.h"
#include "mesh_arrays.h"

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/clod_file.h"
#include "thigma/core/error.h"
#include "thigma/import/read_mesh.h"
#include "thigma/import/write_mesh.h"
#include "thigma/scene/asset_cache.h"

namespace thigma::python {
namespace {

template <class Source>
Mesh made(const Source& source, double scale, bool repair) {
  Mesh mesh;
  mesh.surface = std::make_shared<const TriangleMesh>(
      bindings::usable_mesh(source, {scale, repair, &mesh.repairs}));
  return mesh;
}

/// The finest patches alone: what an exact query needs.
ClodPointer exact_clod(const Mesh& mesh) {
  ClodAsset asset;
  asset.hierarchy = build_exact_hierarchy(*mesh.surface);
  return std::make_shared<const ClodAsset>(std::move(asset));
}

struct BuildRequest {
  int threads = 0;
  std::optional<double> contact_tolerance;
  std::function<void(double)> progress;
};

ClodPointer build(const Mesh& mesh, const BuildRequest& request) {
  ClodParams params;
  const auto hardware = static_cast<int>(std::thread::hardware_concurrency());
  params.threads = request.threads > 0 ? request.threads : std::clamp(hardware, 1, 256);
  if (request.contact_tolerance) {
    if (!(*request.contact_tolerance > 0.0 && std::isfinite(*request.contact_tolerance)))
      throw InputError("build_clod: contact_tolerance must be a finite length above 0 [m]");
    params.contact_tolerance =
        *request.contact_tolerance / enclosing_ball(mesh.surface->positions).radius;
  }
  params.simplify.progress = [&](double share) {
    const py::gil_scoped_acquire lock;
    if (request.progress) request.progress(share);
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  return std::make_shared<const ClodAsset>(build_clod_asset(*mesh.surface, params));
}

py::list level_list(const ClodAsset& asset) {
  py::list levels;
  const ClodHierarchy& h = asset.hierarchy;
  for (std::size_t k = 0; k < h.levels.size(); ++k) {
    const ClodLevel& level = h.levels[k];
    py::dict d;
    d["is_free"] = level.is_free;
    d["triangles"] = k == 0 ? h.triangle_count : level.triangle_count;
    d["patches"] = k == 0          ? static_cast<std::int32_t>(h.patches.size())
                   : level.is_free ? level.node_count
                                   : level.patch_count;
    d["resolution"] = level.resolution;
    d["deviation_max"] = level.deviation_max;
    d["hausdorff_max"] =
        k > 0 && !level.is_free ? level.contact_hausdorff_max : level.hausdorff_max;
    levels.append(std::move(d));
  }
  return levels;
}

Mesh level_mesh(const ClodPointer& asset, std::size_t level) {
  if (level >= asset->meshes.size())
    throw py::index_error("level " + std::to_string(level) +
                          " has no mesh of its own, expected below " +
                          std::to_string(asset->meshes.size()));
  return {MeshPointer(asset, &asset->meshes[level]), {}};
}

/// Whether levels were built, also of a surface too plain to have any. Scenes with exact contacts
/// keep the finest surface alone beside its hierarchy.
bool has_levels(const ClodAsset& asset) {
  return asset.meshes.size() > 1 || asset.origin.max_vertices > 0;
}

void bind_mesh(py::module_& module) {
  py::class_<Mesh>(module, "Mesh")
      .def(py::init([](const Doubles& vertices, const Ints& triangles, double scale, bool repair) {
             const bindings::MeshArrays arrays{vertices.data(), vertices.shape(0), triangles.data(),
                                               triangles.shape(0)};
             const py::gil_scoped_release unlocked;
             return made(arrays, scale, repair);
           }),
           py::arg("vertices"), py::arg("triangles"), py::arg("scale"), py::arg("repair"))
      .def_static("from_file", &made<std::string>, WithoutGil())
      .def_property_readonly("vertices",
                             [](const py::object& self) {
                               const auto& p = self.cast<const Mesh&>().surface->positions;
                               return view(p.empty() ? nullptr : p.front().data(),
                                           {static_cast<py::ssize_t>(p.size()), 3}, self);
                             })
      .def_property_readonly("triangles",
                             [](const py::object& self) {
                               const auto& t = self.cast<const Mesh&>().surface->triangles;
                               return view(t.empty() ? nullptr : t.front().data(),
                                           {static_cast<py::ssize_t>(t.size()), 3}, self);
                             })
      .def_readonly("repairs", &Mesh::repairs)
      .def_property_readonly(
          "radius", [](const Mesh& mesh) { return enclosing_ball(mesh.surface->positions).radius; })
      .def(
          "save",
          [](const Mesh& mesh, const std::string& path) { write_mesh(*mesh.surface, path); },
          WithoutGil());
}

}  // namespace

void bind_meshes(py::module_& module) {
  bind_mesh(module);
  py::class_<ClodAsset, std::shared_ptr<ClodAsset>>(module, "Clod")
      .def_property_readonly("radius", [](const ClodAsset& a) { return a.hierarchy.radius; })
      .def_property_readonly("center",
                             [](const ClodAsset& a) { return to_array(a.hierarchy.center); })
      .def_property_readonly("triangle_count",
                             [](const ClodAsset& a) { return a.hierarchy.triangle_count; })
      .def_property_readonly("has_levels", &has_levels)
      .def_property_readonly("levels", &level_list)
      .def("mesh",
           [](const std::shared_ptr<ClodAsset>& a, std::size_t k) { return level_mesh(a, k); })
      .def(
          "save", [](const ClodAsset& a, const std::string& path) { write_clod(a, path); },
          WithoutGil());
  module.def(
      "build_exact",
      [](const Mesh& m) { return std::const_pointer_cast<ClodAsset>(exact_clod(m)); },
      WithoutGil());
  module.def("build_clod", [](const Mesh& mesh, int threads, std::optional<double> tolerance,
                              std::function<void(double)> progress) {
    const py::gil_scoped_release unlocked;
    return std::const_pointer_cast<ClodAsset>(
        build(mesh, {threads, tolerance, std::move(progress)}));
  });
  module.def(
      "load_clod",
      [](const std::string& path, double scale) {
        return std::make_shared<ClodAsset>(read_clod(path, scale));
      },
      WithoutGil());
  module.def("is_clod_file", &is_clod_file);
  module.def("mesh_formats", [] {
    py::dict endings;
    for (const MeshKind& kind : mesh_kinds()) endings[kind.name] = kind.ending;
    return endings;
  });
}

}  // namespace thigma::python
