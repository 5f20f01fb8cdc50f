// Contacts at poses: one call, columns out.

#include "bind.h"
#include "contact_table.h"

namespace thigma::python {
namespace {

py::dict columns(bindings::ContactTable&& t) {
  py::dict d;
  d["distance"] = take<double>(std::move(t.distance));
  d["start"] = take<std::int64_t>(std::move(t.start));
  d["point"] = take<double>(std::move(t.point));
  d["scene_point"] = take<double>(std::move(t.scene_point));
  d["normal"] = take<double>(std::move(t.normal));
  d["depth"] = take<double>(std::move(t.depth));
  d["bound"] = take<double>(std::move(t.bound));
  d["level"] = take<std::int32_t>(std::move(t.level));
  d["cpu"] = take<double>(std::move(t.cpu));
  d["front"] = take<std::int64_t>(std::move(t.front));
  d["tests"] = take<std::int64_t>(std::move(t.tests));
  return d;
}

/// Every key is there; the Python files fill in what a caller leaves out.
Resolution resolution_of(const py::dict& options) {
  Resolution r;
  r.is_exact = options["is_exact"].cast<bool>();
  r.metric.haptic = options["threshold"].cast<double>();
  r.metric.velocity = options["velocity"].cast<double>();
  r.deviation_cap = options["deviation_cap"].cast<double>();
  r.budget_tests = options["budget_tests"].cast<std::int64_t>();
  r.budget_cpu = options["budget_cpu"].cast<double>();
  r.step_time = options["step_time"].cast<double>();
  return r;
}

py::dict contacts(const std::shared_ptr<ClodAsset>& object, const std::shared_ptr<ClodAsset>& scene,
                  const Doubles& rows, const Doubles& scene_row, double tolerance,
                  const py::dict& options) {
  bindings::TableQuery query;
  query.contact.tolerance = tolerance;
  query.contact.resolution = resolution_of(options);
  query.is_fresh = options["fresh"].cast<bool>();
  const PlacedHierarchy placed{scene->hierarchy, pose_from(scene_row, "scene_pose")};
  const std::span<const double> numbers = numbers_of(rows);
  bindings::ContactTable table;
  {
    const py::gil_scoped_release unlocked;
    const std::vector<Pose> poses = bindings::poses_from_rows(numbers, "poses");
    table = bindings::contacts_at_poses(object->hierarchy, placed, poses, query, check_signals);
  }
  return columns(std::move(table));
}

}  // namespace

void bind_contacts(py::module_& module) { module.def("contacts", &contacts); }

}  // namespace thigma::python
