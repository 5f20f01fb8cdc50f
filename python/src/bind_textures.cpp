// Haptic textures and the depth between textured surfaces.

#include <numeric>

#include "bind.h"
#include "contact_table.h"

#include "thigma/core/error.h"
#include "thigma/depth/depth.h"
#include "thigma/files/file.h"
#include "thigma/texture/bake.h"

namespace thigma::python {
namespace {

using TexturePointer = std::shared_ptr<TextureAsset>;

py::object or_none(const std::optional<double>& number) {
  return number ? py::object(py::float_(*number)) : py::object(py::none());
}

/// (height, width, 3) of the displacements, without the repeated row and column.
py::array_t<float> displacements(const TextureAsset& asset) {
  const HapticTexture& t = asset.texture;
  py::array_t<float> array({t.height, t.width, 3});
  auto out = array.mutable_unchecked<3>();
  for (py::ssize_t j = 0; j < t.height; ++j) {
    for (py::ssize_t i = 0; i < t.width; ++i) {
      const Texel& texel = t.texels[static_cast<std::size_t>(j * (t.width + 1) + i)];
      out(j, i, 0) = texel.x;
      out(j, i, 1) = texel.y;
      out(j, i, 2) = texel.z;
    }
  }
  return array;
}

TexturePointer bake(const Mesh& fine, const Mesh& coarse, int texels, std::uint64_t seed) {
  return std::make_shared<TextureAsset>(bake_surface(
      *fine.surface, *coarse.surface, {.texels = texels, .seed = seed}, "the coarse mesh"));
}

std::unique_ptr<DepthBackend> backend_of(const py::dict& options) {
  const int resolution = options["resolution"].cast<int>();
  if (options["method"].cast<std::string>() == "branch") return make_branch_depth({});
  return make_grid_depth({.resolution = resolution});
}

std::vector<std::int32_t> all_triangles(const HapticTexture& texture) {
  std::vector<std::int32_t> all(texture.coarse.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// (n) depths, (n) whether both are height fields there, along one direction.
py::dict depths(const TexturePointer& object, const TexturePointer& scene, const Doubles& rows,
                const Doubles& scene_pose, const Doubles& direction, const py::dict& options) {
  const std::vector<Pose> poses = bindings::poses_from_rows(numbers_of(rows), "poses");
  const Pose standing = pose_from(scene_pose, "scene_pose");
  const std::unique_ptr<DepthBackend> backend = backend_of(options);
  const std::vector<std::int32_t> held = all_triangles(object->texture),
                                  below = all_triangles(scene->texture);
  std::vector<double> depth(poses.size());
  std::vector<std::uint8_t> found(poses.size()), height_field(poses.size());
  DepthContact contact;
  contact.scene = {&scene->texture, below, standing};
  contact.normal = Vec3(direction.data()[0], direction.data()[1], direction.data()[2]);
  {
    const py::gil_scoped_release unlocked;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (i % 64 == 63) check_signals();
      contact.object = {&object->texture, held, poses[i]};
      contact.point = contact.centre = poses[i].position;
      DepthSamples sample;
      backend->sample({&contact, 1}, {}, {&sample, 1});
      depth[i] = sample.is_found ? sample.depth[0] : kNoDepth;
      found[i] = sample.is_found;
      height_field[i] = sample.is_found && sample.is_height_field;
    }
  }
  py::dict result;
  result["depth"] = take<double>(std::move(depth));
  result["is_height_field"] = take<std::uint8_t>(std::move(height_field));
  return result;
}

}  // namespace

void bind_textures(py::module_& module) {
  py::class_<TextureAsset, TexturePointer>(module, "Texture")
      .def_property_readonly("width", [](const TextureAsset& a) { return a.texture.width; })
      .def_property_readonly("height", [](const TextureAsset& a) { return a.texture.height; })
      .def_property_readonly("texel_size",
                             [](const TextureAsset& a) { return a.texture.texel_size; })
      .def_property_readonly("amplitude", [](const TextureAsset& a) { return a.texture.amplitude; })
      .def_property_readonly("charts", [](const TextureAsset& a) { return a.figures.charts; })
      .def_property_readonly("distortion_max",
                             [](const TextureAsset& a) { return a.figures.distortion_max; })
      .def_property_readonly("fit_error_rms",
                             [](const TextureAsset& a) { return or_none(a.figures.fit_error_rms); })
      .def_property_readonly("fit_error_max",
                             [](const TextureAsset& a) { return or_none(a.figures.fit_error_max); })
      .def_property_readonly("crack_max",
                             [](const TextureAsset& a) { return or_none(a.figures.crack_max); })
      .def_property_readonly("displacements", &displacements)
      .def_property_readonly("coarse",
                             [](const TexturePointer& a) {
                               return Mesh{MeshPointer(a, &a->texture.coarse), {}};
                             })
      .def(
          "save",
          [](const TextureAsset& a, const std::string& path) {
            write_file(path, format_texture(a));
          },
          WithoutGil());
  module.def("bake", &bake, WithoutGil());
  module.def(
      "load_texture",
      [](const std::string& path, double scale) {
        return std::make_shared<TextureAsset>(read_texture(path, scale));
      },
      WithoutGil());
  module.def("depths", &depths);
}

}  // namespace thigma::python
