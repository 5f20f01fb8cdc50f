#pragma once
// Parts of the module, and what they share: arrays in and out, waiting that Ctrl-C ends.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/math/pose.h"

namespace thigma::python {

namespace py = pybind11;

/// Arrays as the Python files hand them over: checked shapes, C order.
using Doubles = py::array_t<double, py::array::c_style>;
using Ints = py::array_t<std::int32_t, py::array::c_style>;
using WithoutGil = py::call_guard<py::gil_scoped_release>;

using MeshPointer = std::shared_ptr<const TriangleMesh>;
/// A mesh as Python holds it. Never changed: views of it are handed out.
struct Mesh {
  MeshPointer surface;
  std::vector<std::string> repairs;
};
/// Levels of detail, or a surface at its finest alone (`meshes` has one, `levels` free ones).
using ClodPointer = std::shared_ptr<const ClodAsset>;

void bind_meshes(py::module_& module);
void bind_contacts(py::module_& module);
void bind_scenes(py::module_& module);
void bind_sessions(py::module_& module);
void bind_recordings(py::module_& module);
void bind_textures(py::module_& module);
void bind_tune(py::module_& module);

/// Read-only view of numbers that `owner` keeps alive.
template <class Number>
py::array_t<Number> view(const Number* numbers, std::vector<py::ssize_t> shape, py::handle owner) {
  py::array_t<Number> array(std::move(shape), numbers, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// A vector's numbers as an array that owns them: (n), or (n, width) for elements of several.
template <class Number, class Element>
py::array_t<Number> take(std::vector<Element>&& numbers) {
  static_assert(sizeof(Element) % sizeof(Number) == 0);
  constexpr auto width = static_cast<py::ssize_t>(sizeof(Element) / sizeof(Number));
  auto* const kept = new std::vector<Element>(std::move(numbers));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Element>*>(p); });
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(kept->size())};
  if (width > 1) shape.push_back(width);
  return py::array_t<Number>(std::move(shape), reinterpret_cast<const Number*>(kept->data()),
                             owner);
}

inline std::span<const double> numbers_of(const Doubles& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// (7,): x, y, z, qx, qy, qz, qw.
Doubles to_array(const Pose& pose);
Doubles to_array(const Vec3& v);
Doubles to_array(const Wrench& wrench);  // (6,): force, torque
Doubles to_array(const Twist& twist);    // (6,): linear, angular

/// One pose of 7 numbers.
Pose pose_from(const Doubles& row, const char* name);

/// Throws KeyboardInterrupt after Ctrl-C. Thread: without the lock of Python.
inline void check_signals() {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace thigma::python
