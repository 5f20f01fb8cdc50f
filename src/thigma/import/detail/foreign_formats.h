#pragma once
// Files that people take for meshes and that are none: named, with the way on.

#include <string_view>

namespace thigma::detail {

/// A kind of file that is no mesh of triangles.
struct ForeignFormat {
  const char* what;      // "a STEP file"
  const char* expected;  // what to do instead
};

/// What kind of file these bytes are; null where it is none of those known. Thread: any.
const ForeignFormat* foreign_format(std::string_view bytes) noexcept;

}  // namespace thigma::detail
