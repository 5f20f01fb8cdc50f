// The gamepads that are pretended: which axes and buttons they have, and what kernel drivers say
// of them. Shared by the process that tells events and the library that answers for the kernel.
#pragma once

#include <cstdint>
#include <vector>

#include "../common/board.h"
#include <linux/input.h>

namespace standin {

struct PadAxis {
  std::uint16_t code = 0;
  Key key = k_axis_x;  // its value, as the device tells it
  int minimum = 0;
  int maximum = 0;
  int fuzz = 0;
  int flat = 0;
};

struct Pad {
  const char* name = "";
  input_id id{};
  std::vector<PadAxis> axes;
  std::vector<std::uint16_t> buttons;  // bit i of the key `buttons` is the i-th
  bool has_rumble = true;
};

// By the key `pad_type`: 0 an Xbox pad, 1 a PlayStation pad, 2 a pad whose cross is four buttons;
// with `not_a_pad` a keyboard.
const Pad& pad_of(int unit);
int axis_value(int unit, const PadAxis& axis);
bool is_pressed(int unit, std::size_t button);

// How the library tells the process of effects, over the connection that stands for the opened
// device: records of the size of input_event, of types that the kernel does not have.
enum EffectRecord : std::uint16_t { kEffectSize = 0xF001, kEffectTime, kEffectErase };

}  // namespace standin
