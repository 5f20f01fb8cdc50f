// libstandin_evdev.so between a client and the kernel: paths below /dev/input lead to the folder of
// standin_gamepad.
#pragma once

#include <cstddef>
#include <string>

#include <dlfcn.h>

#define STANDIN_CALL extern "C" __attribute__((visibility("default")))

namespace standin {

constexpr unsigned kMajor = 13;  // of input devices; the minor of event0 is 64
constexpr unsigned kMinor = 64;

// The C library's own.
template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// The path of the stand-in for one of the kernel's, empty where it is not ours.
std::string ours(const char* path);
int unit_of_path(const std::string& path);
// Whether the board of standin_gamepad is there.
bool has_board();
// Opens a gamepad; -1 with errno as of the kernel.
int connect_pad(const std::string& path, int flags);

// Which gamepad an open descriptor stands for, -1 where it is none of them.
int unit_of_descriptor(int fd);
void forget_descriptor(int fd);
// Whether the device behind a descriptor is still plugged in.
bool is_there(int fd);
int answer_ioctl(int fd, int unit, unsigned long request, void* argument);

}  // namespace standin
