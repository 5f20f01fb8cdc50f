#pragma once
// A shared library opened at run time, so that vendor software is never needed to build or to
// start.

#include <optional>
#include <span>
#include <string>

namespace thigma {

/// Owns one opened library. Movable, closed at the end of its life.
/// Thread [offline].
class SharedLibrary {
 public:
  /// The first of `names` that opens, symbols local to us; or nothing.
  ///
  /// names  file names or paths, tried in order
  /// error  null, or why each one did not open, one line
  static std::optional<SharedLibrary> open(std::span<const char* const> names,
                                           std::string* error = nullptr);

  SharedLibrary(SharedLibrary&& other) noexcept;
  SharedLibrary& operator=(SharedLibrary&& other) noexcept;
  ~SharedLibrary();

  /// The name that opened.
  const std::string& name() const { return name_; }
  /// Address of a symbol, or null.
  void* symbol(const char* name) const;
  /// The same as a function; null where the library lacks it.
  template <class Function>
  void find(const char* name, Function& function) const {
    function = reinterpret_cast<Function>(symbol(name));
  }
  /// The first of `names` that the library lacks, or null when it has all.
  const char* first_missing(std::span<const char* const> names) const;

 private:
  SharedLibrary(void* handle, std::string name);
  void* handle_ = nullptr;
  std::string name_;
};

}  // namespace thigma
