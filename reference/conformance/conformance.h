#pragma once
// Reference vectors in the schema of docs/formats.md against this engine's own functions.

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "reference/conformance/json_fields.h"

namespace thigma::app {

/// A value passes when |got - want| <= absolute + relative * max |want of its array|.
struct Tolerance {
  double absolute = 0.0;
  double relative = 0.0;
};

/// The comparison that came nearest to failing, or failed most.
struct WorstField {
  std::string name;  // of the case
  std::string field;
  double error = -1.0;  // largest |got - want|; infinite when one of them is not finite
  double used = -1.0;   // error over what is allowed; > 1 fails
};

/// Compares what the engine computed for one case with what the case expects.
class CaseCheck {
 public:
  CaseCheck(const JsonField& expected, const Tolerance& tolerance)
      : expected_(expected), tolerance_(tolerance) {}

  /// Compares with the field of this name of the case. Throw InputError when it is absent or of
  /// another shape.
  template <class Derived>
  void expect(const char* name, const Eigen::MatrixBase<Derived>& got) {
    compare(take(name), got, tolerance_);
  }
  void expect(const char* name, double got) { compare(take(name), {got}, {}, tolerance_); }
  void expect(const char* name, const std::vector<double>& got) {
    compare(take(name), got, {got.size()}, tolerance_);
  }
  void expect_flag(const char* name, bool got);
  void expect_whole(const char* name, long got);
  /// Whole numbers, in order and number.
  void expect_list(const JsonField& want, const std::vector<long>& got);

  /// Compares with any place of the case.
  template <class Derived>
  void compare(const JsonField& want, const Eigen::MatrixBase<Derived>& got,
               const Tolerance& tolerance) {
    const Eigen::Matrix<double, Derived::RowsAtCompileTime, Derived::ColsAtCompileTime> values =
        got;
    std::vector<double> row_by_row;
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      for (Eigen::Index j = 0; j < values.cols(); ++j) row_by_row.push_back(values(i, j));
    }
    std::vector<std::size_t> shape{static_cast<std::size_t>(values.rows())};
    if (values.cols() > 1) shape.push_back(static_cast<std::size_t>(values.cols()));
    compare(want, row_by_row, shape, tolerance);
  }
  void compare(const JsonField& want, const std::vector<double>& got,
               const std::vector<std::size_t>& shape, const Tolerance& tolerance);
  void compare(const JsonField& want, double got) { compare(want, {got}, {}, tolerance_); }

  /// The field of this name, counted as compared.
  JsonField take(const char* name);
  bool has(const char* name) const { return expected_.has(name); }
  /// Something that is not a number differs: fails with an infinite error.
  void differ(const JsonField& want);

  const Tolerance& tolerance() const { return tolerance_; }
  const WorstField& worst() const { return worst_; }
  bool passed() const { return worst_.used <= 1.0; }
  /// Whether every field of the case was compared.
  bool is_complete() const { return taken_.size() == expected_.value->size(); }

 private:
  void note(const JsonField& want, double error, double allowed);

  JsonField expected_;
  Tolerance tolerance_;
  WorstField worst_;
  std::set<std::string> taken_;
};

/// What a check may need of the file besides the case.
struct CaseContext {
  bool has_difference_tolerance = false;
  Tolerance difference;  // fd_tolerance
  Tolerance depth;       // delta_abs of the tolerance, for the fields of kinds that have it
  Tolerance slope;       // slope_abs
};

/// One kind of vectors: recognised by fields of "in", else by the file's name.
struct ConformanceKind {
  const char* name;                 // also how the file is called
  std::vector<const char*> fields;  // all of them are in "in", and in no other kind's before it
  void (*check)(const JsonField& in, CaseCheck& check, const CaseContext& context);
};
const std::vector<ConformanceKind>& conformance_kinds();

struct ConformanceReport {
  std::string file;
  int cases = 0;
  int passed = 0;
  int failed = 0;
  int not_implemented = 0;  // cases with results the engine does not compute
  WorstField worst;
};

/// Runs every case of a document; `file` is its name for messages. Throws InputError on anything
/// out of schema.
ConformanceReport check_document(const std::string& file, const std::string& text);

// Checks of rotation.cpp, force.cpp, step.cpp, contact.cpp and simplify.cpp.
void check_rotations(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_spline(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_coupling(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_penalty(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_texture_point(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_texture_disk(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_integrators(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_linearized_contact(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_clustering(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_resolution(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_collapse_lp(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_bisection(const JsonField& in, CaseCheck& check, const CaseContext& context);
void check_error_metric(const JsonField& in, CaseCheck& check, const CaseContext& context);

}  // namespace thigma::app
