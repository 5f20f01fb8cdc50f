// Recordings as columns. The columns of frames are those of the lists in loop/sample_fields.h.

#include <algorithm>
#include <concepts>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

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
using Stored = std::conditional_t<
    std::is_same_v<Value, Fault>, Fault,
    std::conditional_t<std::is_same_v<Value, bool>, std::uint8_t,
                       std::conditional_t<std::is_floating_point_v<Value>, double, std::int64_t>>>;

using Column = std::variant<std::vector<double>, std::vector<std::int64_t>,
                            std::vector<std::uint8_t>, std::vector<Fault>>;

py::object to_python(const std::vector<double>& c) {
  return py::array_t<double>(static_cast<py::ssize_t>(c.size()), c.data());
}
py::object to_python(const std::vector<std::int64_t>& c) {
  return py::array_t<std::int64_t>(static_cast<py::ssize_t>(c.size()), c.data());
}
py::object to_python(const std::vector<std::uint8_t>& c) {
  py::array_t<bool> array(static_cast<py::ssize_t>(c.size()));
  std::copy(c.begin(), c.end(), array.mutable_data());
  return std::move(array);
}
py::object to_python(const std::vector<Fault>& c) {
  py::list list(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) list[i] = py::str(fault_name(c[i]));
  return std::move(list);
}

/// One column for each number that `walk` visits of a sample, a row a sample. Samples themselves,
/// with all rows of a contact model, would take a hundred times as much.
template <class Sample, class Walk>
class Columns {
 public:
  explicit Columns(Walk walk) : walk_(walk) {
    walk_(Sample{}, ColumnVisitor{[&](const std::string& name, const auto& value) {
            using Value = std::decay_t<decltype(value)>;
            columns_.emplace_back(name, std::vector<Stored<Value>>());
          }});
  }
  void add(const Sample& sample) {
    std::size_t column = 0;
    walk_(sample, ColumnVisitor{[&](const std::string&, const auto& value) {
            using Number = Stored<std::decay_t<decltype(value)>>;
            std::get<std::vector<Number>>(columns_[column++].second)
                .push_back(static_cast<Number>(value));
          }});
  }
  py::dict made() const {
    py::dict dict;
    for (const auto& [name, column] : columns_)
      dict[py::str(name)] = std::visit([](const auto& c) { return to_python(c); }, column);
    return dict;
  }

 private:
  Walk walk_;
  std::vector<std::pair<std::string, Column>> columns_;
};

py::dict read(const std::string& path) {
  const auto visit_frame = [](const HapticSample& s, auto&& visit) { visit_columns(s, visit); };
  const auto visit_contact = [](const ContactSample& s, auto&& visit) {
    visit_contact_frame(s, visit);
    visit_contact_levels(s, visit);
    visit_contact_rows(s, visit);
  };
  Columns<HapticSample, decltype(visit_frame)> frames(visit_frame);
  Columns<ContactSample, decltype(visit_contact)> contacts(visit_contact);
  RecordingInfo recording;
  {
    const py::gil_scoped_release unlocked;
    RecordingSinks sinks;
    sinks.frame = [&](const HapticSample& s, const SamplePlace&) { frames.add(s); };
    sinks.contact = [&](const ContactSample& s, const SamplePlace&) { contacts.add(s); };
    recording = stream_recording(path, sinks);
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
  d["frames"] = frames.made();
  d["contacts"] = contacts.made();
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
