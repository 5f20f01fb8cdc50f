// What tests of OpenHaptics' stand-in share.
#pragma once

#include "client.h"

namespace standin_test {

struct ErrorInfo {
  unsigned error = 0;
  int internal_error = 0;
  unsigned device = 0;
};

constexpr unsigned kNoHandle = 0xFFFFFFFFu;
constexpr unsigned short kLowest = 0;
constexpr unsigned short kHighest = 0xFFFF;

inline const Library& hd() {
  static const Library library("hd", "libHD.so");
  return library;
}
inline const char* nobody() { return nullptr; }
inline void begin() { hd().call<void>("hdBeginFrame", 0u); }
inline void end() { hd().call<void>("hdEndFrame", 0u); }
inline unsigned error() { return hd().call<ErrorInfo>("hdGetError").error; }

class HdTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(hd().is_open()) << dlerror();
    hd().reset();
  }
  void TearDown() override {
    hd().set("hang", 0);
    hd().call<void>("hdStopScheduler");
    hd().call<void>("hdDisableDevice", 0u);
  }

  static void open() { ASSERT_EQ(hd().call<unsigned>("hdInitDevice", nobody()), 0u); }

  // Motors on, the servo loop running.
  static void open_with_force() {
    open();
    hd().call<void>("hdEnable", 0x4000u);
    hd().call<void>("hdDisable", 0x4002u);  // no ramp
    hd().call<void>("hdStartScheduler");
  }

  // One call in the servo thread.
  static void run_once(void (*act)()) {
    hd().call<void>("hdStartScheduler");
    const auto callback = +[](void* data) -> unsigned {
      reinterpret_cast<void (*)()>(data)();
      return 0;
    };
    hd().call<void>("hdScheduleSynchronous", callback, reinterpret_cast<void*>(act), kHighest);
  }

  static void set_force(double x, double y, double z) {
    const double force[3] = {x, y, z};
    begin();
    hd().call<void>("hdSetDoublev", 0x2700u, static_cast<const double*>(force));
    end();
  }
};

}  // namespace standin_test
