#include "thigma/core/shared_library.h"

#include <utility>

#include <dlfcn.h>

namespace thigma {

SharedLibrary::SharedLibrary(void* handle, std::string name)
    : handle_(handle), name_(std::move(name)) {}

SharedLibrary::SharedLibrary(SharedLibrary&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)), name_(std::move(other.name_)) {}

SharedLibrary& SharedLibrary::operator=(SharedLibrary&& other) noexcept {
  std::swap(handle_, other.handle_);
  std::swap(name_, other.name_);
  return *this;
}

SharedLibrary::~SharedLibrary() {
  if (handle_ != nullptr) dlclose(handle_);
}

std::optional<SharedLibrary> SharedLibrary::open(std::span<const char* const> names,
                                                 std::string* error) {
  if (error != nullptr) error->clear();
  for (const char* name : names) {
    if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return SharedLibrary(handle, name);
    const char* why = dlerror();
    if (error == nullptr) continue;
    if (!error->empty()) *error += "; ";
    *error += why != nullptr ? why : name;
  }
  return std::nullopt;
}

void* SharedLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

const char* SharedLibrary::first_missing(std::span<const char* const> names) const {
  for (const char* name : names) {
    if (symbol(name) == nullptr) return name;
  }
  return nullptr;
}

}  // namespace thigma
