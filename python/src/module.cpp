// The module thigma._core: exceptions, and the parts in the order of their use.

#include <string>

#include "bind.h"
#include "contact_table.h"

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"

namespace thigma::python {
namespace {

Doubles row(std::initializer_list<Vec3> vectors) {
  Doubles array(static_cast<py::ssize_t>(3 * vectors.size()));
  double* at = array.mutable_data();
  for (const Vec3& v : vectors)
    for (int i = 0; i < 3; ++i) *at++ = v[i];
  return array;
}

/// An exception that is also one of Python's own, so that either may be caught.
template <class Error>
void add_error(py::module_& module, const py::object& base, const char* name, PyObject* own,
               const char* meaning) {
  py::register_exception<Error>(module, name, py::make_tuple(base, py::handle(own))).doc() =
      meaning;
}

}  // namespace

Doubles to_array(const Pose& pose) {
  Doubles array(7);
  double* v = array.mutable_data();
  for (int i = 0; i < 3; ++i) v[i] = pose.position[i];
  for (int i = 0; i < 4; ++i) v[3 + i] = pose.orientation.coeffs()[i];
  return array;
}

Doubles to_array(const Vec3& v) { return row({v}); }
Doubles to_array(const Wrench& wrench) { return row({wrench.force, wrench.torque}); }
Doubles to_array(const Twist& twist) { return row({twist.linear, twist.angular}); }

Pose pose_from(const Doubles& row, const char* name) {
  return bindings::poses_from_rows(numbers_of(row), name).at(0);
}

}  // namespace thigma::python

PYBIND11_MODULE(_core, module) {
  using namespace thigma::python;
  module.doc() = "What thigma's Python files call; nothing of it is promised.";
  module.attr("__version__") = THIGMA_VERSION;
  const py::object base = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc("thigma.Error", "Base of what thigma raises.", nullptr, nullptr));
  module.attr("Error") = base;
  add_error<thigma::InputError>(module, base, "InputError", PyExc_ValueError,
                                "What was given is wrong: what, where, what was expected.");
  add_error<thigma::IoError>(module, base, "IoError", PyExc_OSError,
                             "The system refused to read or write.");
  add_error<thigma::DeviceAddressError>(module, base, "DeviceAddressError", PyExc_ValueError,
                                        "A device address that cannot be understood.");
  add_error<thigma::DeviceUnavailable>(module, base, "DeviceUnavailable", PyExc_RuntimeError,
                                       "A device that is not there, or not of this build.");
  bind_meshes(module);
  bind_contacts(module);
  bind_scenes(module);
  bind_sessions(module);
  bind_recordings(module);
  bind_textures(module);
  bind_tune(module);
}
