// Stand-ins as a client meets them: opened at run time, every function by its name.
#pragma once

#include <string>

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace standin_test {

class Library {
 public:
  // Folder under build/PRESET/standins and the vendor's file name.
  Library(const char* folder, const char* file)
      : handle_(dlopen((std::string(STANDIN_FOLDER "/") + folder + "/" + file).c_str(),
                       RTLD_NOW | RTLD_LOCAL)) {}

  bool is_open() const { return handle_ != nullptr; }
  bool has(const char* name) const { return dlsym(handle_, name) != nullptr; }

  template <class Result = int, class... Arguments>
  Result call(const char* name, Arguments... arguments) const {
    auto* function = reinterpret_cast<Result (*)(Arguments...)>(dlsym(handle_, name));
    EXPECT_NE(function, nullptr) << name;
    return function(arguments...);
  }

  void set(const char* key, double value) const {
    EXPECT_EQ(call("standin_set", key, value), 0) << key;
  }
  double get(const char* key) const { return call<double>("standin_get", key); }
  void reset() const { call<void>("standin_reset"); }

 private:
  void* handle_ = nullptr;
};

constexpr signed char kDefault = -1;  // the vendor's "the default device"

// Waits until a condition holds, at most that many seconds.
template <class Condition>
bool wait_for(Condition condition, double seconds = 10.0) {
  for (double waited = 0.0; waited < seconds; waited += 0.001) {
    if (condition()) {
      return true;
    }
    usleep(1000);
  }
  return condition();
}

}  // namespace standin_test
