// Recordings as columns. The columns of frames are those of the lists in loop/sample_fields.h.

#include <concepts>
#include <type_traits>

#include "bind.h"

#include "thigma/loop/sample_fields.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"

namespace thigma::python {
namespace {

/// Calls visit(name) for each column, with the value of one sample.
template <class Visit>
struct ColumnVisitor {
  Visit visit;

  template <class Value>
  void operator()(const std::string& name, const Value& value) const {
    visit(name, value);
  }
  template <class Vector>
  void vector(const char* name, const char* unit, const Vector& v) const {
    constexpr const char* kAxes[] = {"x", "y", "z", "w"};
    for (int i = 0; i < static_cast<int>(v.size()); ++i)
      visit(name + std::string(kAxes[i]) + unit, static_cast<double>(v[i]));
  }
  template <class Value>
  void unless(const char* name, const Value& value, const Value&) const {
    visit(name, value);
  }
  template <class Counts>
  void counts(const char*, const Counts&) const {}
};
template <class Visit>
ColumnVisitor(Visit) -> ColumnVisitor<Visit>;

/// Number of a column: an enumeration is its name, the others as they are.
template <class Value>
using Stored =
    std::conditional_t<std::is_same_v<Value, bool>, bool,
                       std::conditional_t<std::is_floating_point_v<Value>, double, std::int64_t>>;

/// One column of all samples that `walk` visits.
template <class Sample, class Walk>
class Columns {
 public:
  Columns(const std::vector<Sample>& samples, Walk walk) : samples_(samples), walk_(walk) {}

  py::dict made() {
    const Sample empty{};
    walk_(empty,
          ColumnVisitor{[&](const std::string& name, const auto& value) { add(name, value); }});
    for (std::size_t row = 0; row < samples_.size(); ++row) {
      std::size_t column = 0;
      walk_(samples_[row], ColumnVisitor{[&](const std::string&, const auto& value) {
              put(column++, row, value);
            }});
    }
    return std::move(dict_);
  }

 private:
  template <class Value>
  void add(const std::string& name, const Value&) {
    if constexpr (std::is_same_v<Value, Fault>) {
      const py::list list(samples_.size());
      places_.push_back(list.ptr());
      dict_[py::str(name)] = list;
    } else {
      py::array_t<Stored<Value>> array(static_cast<py::ssize_t>(samples_.size()));
      places_.push_back(array.mutable_data());
      dict_[py::str(name)] = array;
    }
  }
  template <class Value>
  void put(std::size_t column, std::size_t row, const Value& value) {
    if constexpr (std::is_same_v<Value, Fault>)
      PyList_SET_ITEM(static_cast<PyObject*>(places_[column]), static_cast<py::ssize_t>(row),
                      py::str(fault_name(value)).release().ptr());
    else
      static_cast<Stored<Value>*>(places_[column])[row] = static_cast<Stored<Value>>(value);
  }

  const std::vector<Sample>& samples_;
  Walk walk_;
  py::dict dict_;
  std::vector<void*> places_;  // in the order of columns
};

py::dict frame_columns(const std::vector<HapticSample>& frames) {
  return Columns(frames, [](const HapticSample& s, auto&& visit) { visit_columns(s, visit); })
      .made();
}

py::dict contact_columns(const std::vector<ContactSample>& contacts) {
  return Columns(contacts,
                 [](const ContactSample& s, auto&& visit) {
                   visit_contact_frame(s, visit);
                   visit_contact_levels(s, visit);
                   visit_contact_rows(s, visit);
                 })
      .made();
}

py::dict read(const std::string& path) {
  Recording recording;
  {
    const py::gil_scoped_release unlocked;
    recording = read_recording(path);
  }
  py::list events;
  for (const SessionEvent& event : recording.events) {
    py::dict e;
    e["time"] = event.time;
    e["frame"] = event.frame;
    e["kind"] = event_name(event.kind);
    e["detail"] = event.detail;
    e["text"] = event.text;
    events.append(std::move(e));
  }
  py::dict d;
  d["frames"] = frame_columns(recording.frames);
  d["contacts"] = contact_columns(recording.contacts);
  d["events"] = events;
  d["config"] = recording.config;
  d["cut_off"] = recording.cut_off;
  d["warnings"] = recording.warnings;
  return d;
}

}  // namespace

void bind_recordings(py::module_& module) {
  module.def("read_recording", &read);
  module.def("replay", [](const std::string& path) {
    ReplayReport report;
    {
      const py::gil_scoped_release unlocked;
      report = replay_recording(path);
    }
    return py::make_tuple(report.identical, report.frames, report.reason);
  });
  module.def(
      "export_csv",
      [](const std::string& path, const std::string& csv) {
        export_csv(read_recording(path), csv);
      },
      WithoutGil());
}

}  // namespace thigma::python
