// Scenes: from files, built-in, or of two meshes.

#include "bind.h"
#include "scene_of_meshes.h"

#include "thigma/scene/load_scene.h"
#include "thigma/scene/scene_file.h"

namespace thigma::python {
namespace {

using ScenePointer = std::shared_ptr<Scene>;

/// Lines for people go to a Python function, where there is one.
Log log_to(std::function<void(const std::string&)> tell) {
  if (!tell) return {};
  return [tell = std::move(tell)](const std::string& line) {
    const py::gil_scoped_acquire lock;
    tell(line);
  };
}

LoadOptions load_options(const py::dict& options) {
  LoadOptions o;
  o.repairs = options["repair"].cast<bool>();
  o.has_textures = options["textures"].cast<bool>();
  o.keeps_levels = options["keep_levels"].cast<bool>();
  o.cache_folder = options["cache_folder"].cast<std::string>();
  if (!options["log"].is_none())
    o.log = log_to(options["log"].cast<std::function<void(const std::string&)>>());
  o.progress = [](const std::string&, double, double) { check_signals(); };
  return o;
}

ScenePointer load(const std::string& path, const py::dict& options) {
  const LoadOptions loading = load_options(options);
  const py::gil_scoped_release unlocked;
  return std::make_shared<Scene>(load_scene(path, loading));
}

ScenePointer load_pair(const std::string& object, const std::string& against, double scale,
                       const Doubles& pose, const std::string& response, const py::dict& options) {
  const LoadOptions loading = load_options(options);
  const Pose world_from_mesh = pose_from(pose, "pose");
  const py::gil_scoped_release unlocked;
  SceneDescription description = scene_from_pair(object, against, scale, world_from_mesh);
  if (!response.empty()) {
    description.contact.response = response_of(response);
    if (!description.contact.response)
      throw py::value_error("response: '" + response +
                            "', expected penalty, constraint, potential or direct");
  }
  return std::make_shared<Scene>(load_scene(std::move(description), loading));
}

ScenePointer mesh_pair(const Mesh& object, const Mesh& against, const Doubles& pose,
                       const std::string& response) {
  const Pose world_from_mesh = pose_from(pose, "pose");
  const py::gil_scoped_release unlocked;
  std::optional<ResponseKind> kind;
  if (!response.empty()) {
    kind = response_of(response);
    if (!kind)
      throw py::value_error("response: '" + response +
                            "', expected penalty, constraint, potential or direct");
  }
  return std::make_shared<Scene>(
      bindings::scene_of_meshes(*object.surface, *against.surface, world_from_mesh, kind));
}

const char* response_name(ResponseKind kind) {
  for (const ResponseName& response : kResponseNames)
    if (response.kind == kind) return response.name;
  return "";
}

py::list surfaces(const ScenePointer& scene) {
  py::list list;
  for (const auto& body : scene->statics) list.append(std::const_pointer_cast<ClodAsset>(body));
  return list;
}

py::list poses(const ScenePointer& scene) {
  py::list list;
  for (const SceneBody& body : scene->config.contact.scene)
    list.append(to_array(body.world_from_body));
  return list;
}

}  // namespace

void bind_scenes(py::module_& module) {
  py::class_<Scene, ScenePointer>(module, "Scene")
      .def_property_readonly("file", [](const Scene& s) { return s.description.file; })
      .def_property_readonly("title", [](const Scene& s) { return s.description.title; })
      .def_property_readonly("device", [](const Scene& s) { return s.description.device.uri; })
      .def_property_readonly("rate", [](const Scene& s) { return s.config.rate; })
      .def_property_readonly("response",
                             [](const Scene& s) { return response_name(s.config.haptic.response); })
      .def_property_readonly("mass", [](const Scene& s) { return s.config.haptic.body.mass; })
      .def_property_readonly("tolerance", [](const Scene& s) { return s.config.contact.tolerance; })
      .def_property_readonly("start",
                             [](const Scene& s) { return to_array(s.config.world_from_body); })
      .def_property_readonly(
          "body_from_mesh",
          [](const Scene& s) { return to_array(s.config.contact.body_from_mesh); })
      .def_property_readonly(
          "object",
          [](const ScenePointer& s) { return std::const_pointer_cast<ClodAsset>(s->object); })
      .def_property_readonly("statics", &surfaces)
      .def_property_readonly("static_poses", &poses);
  module.def("load_scene", &load);
  module.def("load_pair", &load_pair);
  module.def("mesh_pair", &mesh_pair);
  module.def("builtin_scene_names", &builtin_scene_names);
}

}  // namespace thigma::python
