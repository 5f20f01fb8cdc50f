#include <algorithm>
#include <filesystem>

#include "reference/conformance/conformance.h"

namespace thigma::app {
namespace {

Tolerance tolerance_in(const JsonField& field) {
  Tolerance t;
  if (field.has("abs")) t.absolute = number(member(field, "abs"));
  if (field.has("rel")) t.relative = number(member(field, "rel"));
  return t;
}

const ConformanceKind* kind_by_fields(const JsonField& in) {
  for (const ConformanceKind& kind : conformance_kinds()) {
    const bool fits = std::all_of(kind.fields.begin(), kind.fields.end(),
                                  [&](const char* f) { return in.has(f); });
    if (fits) return &kind;
  }
  return nullptr;
}

const ConformanceKind* kind_by_name(const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem().string();
  for (const ConformanceKind& kind : conformance_kinds()) {
    if (stem.rfind(kind.name, 0) == 0) return &kind;
  }
  return nullptr;
}

// The first case decides when it has no name of its own: files of one kind may hold a malformed
// case.
const ConformanceKind& kind_of(const JsonField& in, const std::string& file) {
  const ConformanceKind* kind = kind_by_fields(in);
  if (!kind) kind = kind_by_name(file);
  if (!kind) fail_field(in, "the fields of a known kind of vectors");
  return *kind;
}

void check_case(const JsonField& entry, const Tolerance& tolerance, const CaseContext& context,
                ConformanceReport& report) {
  const std::string name = text(member(entry, "name"));
  const JsonField in = member(entry, "in");
  const JsonField out = member(entry, "out");
  if (!in.value->is_object()) fail_field(in, "an object");
  if (!out.value->is_object() || out.value->empty()) fail_field(out, "an object with results");
  const ConformanceKind& kind = kind_of(in, report.file);
  ++report.cases;
  CaseCheck check(out, tolerance);
  kind.check(in, check, context);
  if (!check.passed()) {
    ++report.failed;
  } else if (!check.is_complete()) {
    ++report.not_implemented;
  } else {
    ++report.passed;
  }
  if (check.worst().used > report.worst.used) {
    report.worst = check.worst();
    report.worst.name = name;
  }
}

}  // namespace

const std::vector<ConformanceKind>& conformance_kinds() {
  static const std::vector<ConformanceKind> kinds = {
      {"integrators", {"body", "y0", "h", "devices"}, check_integrators},
      {"linearized_contact", {"body", "y0", "y1"}, check_linearized_contact},
      {"coupling", {"body", "y", "coupling", "device"}, check_coupling},
      {"penalty", {"body", "y", "contact"}, check_penalty},
      {"texture_point", {"y", "texture"}, check_texture_point},
      {"texture_disk", {"radius", "amp", "lambda"}, check_texture_disk},
      {"spline", {"spline", "r"}, check_spline},
      {"clustering", {"K", "d", "contacts"}, check_clustering},
      {"resolution", {"v1", "v2", "n"}, check_resolution},
      {"collapse_lp", {"v_hat", "v_tilde", "constraints"}, check_collapse_lp},
      {"bisection", {"u_local", "global_ok_iff_u_ge", "K"}, check_bisection},
      {"error_metric", {"s_a", "s_b"}, check_error_metric},
      {"rotations", {"a"}, check_rotations},
  };
  return kinds;
}

ConformanceReport check_document(const std::string& file, const std::string& text) {
  nlohmann::json document;
  try {
    document = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(file + ": not JSON at byte " + std::to_string(error.byte) +
                     ", expected reference vectors");
  }
  const JsonField root{&document, file, true};
  if (!root.value->is_object()) fail_field(root, "an object with \"cases\"");
  const JsonField schema = member(root, "schema");
  if (whole_number(schema) != 1) fail_field(schema, "schema 1");
  const JsonField tolerance_field = member(root, "tolerance");
  if (!tolerance_field.value->is_object()) fail_field(tolerance_field, "an object");
  const Tolerance tolerance = tolerance_in(tolerance_field);
  CaseContext context;
  if (tolerance_field.has("delta_abs"))
    context.depth.absolute = number(member(tolerance_field, "delta_abs"));
  if (tolerance_field.has("slope_abs"))
    context.slope.absolute = number(member(tolerance_field, "slope_abs"));
  if (root.has("fd_tolerance")) {
    context.has_difference_tolerance = true;
    context.difference = tolerance_in(member(root, "fd_tolerance"));
  }
  ConformanceReport report;
  report.file = file;
  const JsonField cases = member(root, "cases");
  if (list_size(cases) == 0) fail_field(cases, "at least one case");
  for (std::size_t i = 0; i < list_size(cases); ++i)
    check_case(element(cases, i), tolerance, context, report);
  if (root.has("bisection")) {  // of collapse_lp: a second list, of the search that follows
    const JsonField searches = member(root, "bisection");
    for (std::size_t i = 0; i < list_size(searches); ++i)
      check_case(element(searches, i), tolerance, context, report);
  }
  return report;
}

}  // namespace thigma::app
