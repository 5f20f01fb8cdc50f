// libstandin_evdev.so between a client and the kernel: paths below /dev/input lead to the folder of
// standin_gamepad.
#pragma once

#include <cstddef>
#include <string>

namespace standin {

// Which gamepad an open descriptor stands for, -1 where it is none of them.
int unit_of_descriptor(int fd);
// Whether the device behind a descriptor is still plugged in.
bool is_there(int fd);
int answer_ioctl(int fd, int unit, unsigned long request, void* argument);

}  // namespace standin
