#include "pad.h"

#include <algorithm>

namespace standin {
namespace {

constexpr int kStick = 32767;

Pad xbox() {
  Pad pad;
  pad.name = "Microsoft X-Box 360 pad";
  pad.id = {BUS_USB, 0x045e, 0x028e, 0x0110};
  pad.axes = {{ABS_X, k_axis_x, -kStick - 1, kStick, 16, 128},
              {ABS_Y, k_axis_y, -kStick - 1, kStick, 16, 128},
              {ABS_Z, k_axis_z, 0, 255, 0, 0},
              {ABS_RX, k_axis_rx, -kStick - 1, kStick, 16, 128},
              {ABS_RY, k_axis_ry, -kStick - 1, kStick, 16, 128},
              {ABS_RZ, k_axis_rz, 0, 255, 0, 0},
              {ABS_HAT0X, k_hat_x, -1, 1, 0, 0},
              {ABS_HAT0Y, k_hat_y, -1, 1, 0, 0}};
  pad.buttons = {BTN_SOUTH,  BTN_EAST,  BTN_NORTH, BTN_WEST,   BTN_TL,    BTN_TR,
                 BTN_SELECT, BTN_START, BTN_MODE,  BTN_THUMBL, BTN_THUMBR};
  return pad;
}

Pad playstation() {
  Pad pad;
  pad.name = "Sony Interactive Entertainment DualSense Wireless Controller";
  pad.id = {BUS_USB, 0x054c, 0x0ce6, 0x0111};
  for (const auto& [code, key] : {std::pair<std::uint16_t, Key>{ABS_X, k_axis_x},
                                  {ABS_Y, k_axis_y},
                                  {ABS_Z, k_axis_z},
                                  {ABS_RX, k_axis_rx},
                                  {ABS_RY, k_axis_ry},
                                  {ABS_RZ, k_axis_rz}}) {
    pad.axes.push_back({code, key, 0, 255, 0, 0});
  }
  pad.axes.push_back({ABS_HAT0X, k_hat_x, -1, 1, 0, 0});
  pad.axes.push_back({ABS_HAT0Y, k_hat_y, -1, 1, 0, 0});
  pad.buttons = {BTN_SOUTH, BTN_EAST,   BTN_NORTH, BTN_WEST, BTN_TL,     BTN_TR,    BTN_TL2,
                 BTN_TR2,   BTN_SELECT, BTN_START, BTN_MODE, BTN_THUMBL, BTN_THUMBR};
  return pad;
}

Pad with_cross() {
  Pad pad = xbox();
  pad.name = "Generic gamepad with a cross of buttons";
  pad.id = {BUS_BLUETOOTH, 0x1234, 0x5678, 0x0001};
  pad.axes.resize(6);
  for (const int code : {BTN_DPAD_UP, BTN_DPAD_DOWN, BTN_DPAD_LEFT, BTN_DPAD_RIGHT}) {
    pad.buttons.push_back(static_cast<std::uint16_t>(code));
  }
  pad.has_rumble = false;
  return pad;
}

Pad keyboard() {
  Pad pad;
  pad.name = "AT Translated Set 2 keyboard";
  pad.id = {BUS_I8042, 1, 1, 0xab41};
  pad.buttons = {KEY_A, KEY_B, KEY_C};
  pad.has_rumble = false;
  return pad;
}

}  // namespace

const Pad& pad_of(int unit) {
  static const Pad kPads[] = {xbox(), playstation(), with_cross(), keyboard()};
  const int type = is_on(unit, k_not_a_pad) ? 3 : static_cast<int>(get(unit, k_pad_type));
  return kPads[std::clamp(type, 0, 3)];
}

int axis_value(int unit, const PadAxis& axis) {
  return std::clamp(static_cast<int>(get(unit, axis.key)), axis.minimum, axis.maximum);
}

bool is_pressed(int unit, std::size_t button) {
  return (static_cast<std::uint64_t>(get(unit, k_buttons)) >> button & 1U) != 0;
}

}  // namespace standin
