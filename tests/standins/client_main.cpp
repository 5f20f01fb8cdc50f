// standin_client LIBRARY hd|drd NEWTONS: sends that force until it is killed. For tests of what
// happens then.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <unistd.h>

namespace {

double force[3] = {};
void* library = nullptr;

template <class Result, class... Arguments>
Result call(const char* name, Arguments... arguments) {
  auto* function = reinterpret_cast<Result (*)(Arguments...)>(dlsym(library, name));
  if (function == nullptr) {
    std::fprintf(stderr, "no %s\n", name);
    std::exit(3);
  }
  return function(arguments...);
}

unsigned send_in_frame(void*) {
  call<void>("hdBeginFrame", 0u);
  call<void>("hdSetDoublev", 0x2700u, static_cast<const double*>(force));
  call<void>("hdEndFrame", 0u);
  return 1;
}

int drive_hd() {
  if (call<unsigned>("hdInitDevice", static_cast<const char*>(nullptr)) != 0) {
    return 3;
  }
  call<void>("hdEnable", 0x4000u);
  call<unsigned long>("hdScheduleAsynchronous", &send_in_frame, static_cast<void*>(nullptr),
                      static_cast<unsigned short>(0xFFFF));
  call<void>("hdStartScheduler");
  for (;;) {
    pause();
  }
}

int drive_drd() {
  const signed char id = -1;
  if (call<int>("drdOpen") < 0 ||
      call<int>("dhdEnableForce", static_cast<unsigned char>(1), id) < 0) {
    return 3;
  }
  for (;;) {
    call<int>("dhdSetForceAndTorqueAndGripperForce", force[0], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id);
    // A machine that stalls longer than the watchdog waits loses its force; this client takes it
    // again.
    call<int>("dhdEnableForce", static_cast<unsigned char>(1), id);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "standin_client LIBRARY hd|drd NEWTONS\n");
    return 2;
  }
  library = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 3;
  }
  force[0] = std::atof(arguments[3]);
  return std::strcmp(arguments[2], "hd") == 0 ? drive_hd() : drive_drd();
}
