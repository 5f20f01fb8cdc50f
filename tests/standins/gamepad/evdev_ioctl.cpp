// The kernel's answers about a gamepad: EVIOCG..., effects, clocks, grabbing.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "evdev.h"
#include "pad.h"
#include <sys/ioctl.h>
#include <sys/socket.h>

namespace standin {
namespace {

constexpr int kEffects = 16;  // what drivers with memoryless effects keep

int refuse(int error) {
  errno = error;
  return -1;
}

int copy_out(void* to, std::size_t room, const void* from, std::size_t size) {
  const std::size_t copied = std::min(room, size);
  std::memcpy(to, from, copied);
  return static_cast<int>(copied);
}

int copy_text(void* to, std::size_t room, const char* text) {
  return copy_out(to, room, text, std::strlen(text) + 1);
}

// Bits as the kernel has them: an array of long.
struct Bits {
  unsigned char byte[(KEY_CNT + 63) / 64 * 8] = {};
  void set(unsigned bit) {
    byte[bit / 8] = static_cast<unsigned char>(byte[bit / 8] | 1U << bit % 8);
  }
};

int copy_bits(void* to, std::size_t room, const Bits& bits, unsigned count) {
  return copy_out(to, room, bits.byte, (count + 63) / 64 * 8);
}

int what_it_has(int unit, unsigned type, void* to, std::size_t room) {
  const Pad& pad = pad_of(unit);
  Bits bits;
  switch (type) {
    case 0:
      bits.set(EV_SYN);
      bits.set(EV_KEY);
      if (!pad.axes.empty()) {
        bits.set(EV_ABS);
      }
      if (pad.has_rumble && is_on(unit, k_rumble)) {
        bits.set(EV_FF);
      }
      return copy_bits(to, room, bits, EV_CNT);
    case EV_KEY:
      for (const std::uint16_t code : pad.buttons) {
        bits.set(code);
      }
      return copy_bits(to, room, bits, KEY_CNT);
    case EV_ABS:
      for (const PadAxis& axis : pad.axes) {
        bits.set(axis.code);
      }
      return copy_bits(to, room, bits, ABS_CNT);
    case EV_FF:
      if (pad.has_rumble && is_on(unit, k_rumble)) {
        bits.set(FF_RUMBLE);
        bits.set(FF_GAIN);
      }
      return copy_bits(to, room, bits, FF_CNT);
    case EV_REL:
      return copy_bits(to, room, bits, REL_CNT);
    default:
      return copy_bits(to, room, bits, 64);
  }
}

int what_is_pressed(int unit, void* to, std::size_t room) {
  Bits bits;
  const Pad& pad = pad_of(unit);
  for (std::size_t i = 0; i < pad.buttons.size(); ++i) {
    if (is_pressed(unit, i)) {
      bits.set(pad.buttons[i]);
    }
  }
  return copy_bits(to, room, bits, KEY_CNT);
}

int where_axis_is(int unit, unsigned code, void* to, std::size_t room) {
  for (const PadAxis& axis : pad_of(unit).axes) {
    if (axis.code == code) {
      const input_absinfo info{
          axis_value(unit, axis), axis.minimum, axis.maximum, axis.fuzz, axis.flat, 0};
      copy_out(to, room, &info, sizeof(info));
      return 0;
    }
  }
  return refuse(EINVAL);
}

void tell_process(int fd, std::uint16_t type, int code, std::uint32_t value) {
  input_event e{};
  e.type = type;
  e.code = static_cast<std::uint16_t>(code);
  e.value = static_cast<int>(value);
  send(fd, &e, sizeof(e), MSG_NOSIGNAL);
}

int upload(int fd, int unit, ff_effect* effect) {
  static bool is_used[kUnits][kEffects] = {};
  if (!pad_of(unit).has_rumble || !is_on(unit, k_rumble)) {
    return refuse(ENOSYS);
  }
  if (effect->type != FF_RUMBLE || effect->id >= kEffects) {
    return refuse(EINVAL);
  }
  if (effect->id < 0) {
    const auto* free = std::find(is_used[unit], is_used[unit] + kEffects, false);
    if (free == is_used[unit] + kEffects) {
      return refuse(ENOSPC);
    }
    effect->id = static_cast<std::int16_t>(free - is_used[unit]);
    is_used[unit][effect->id] = true;
  }
  const ff_rumble_effect& r = effect->u.rumble;
  tell_process(fd, kEffectSize, effect->id,
               static_cast<std::uint32_t>(r.strong_magnitude) << 16 | r.weak_magnitude);
  tell_process(fd, kEffectTime, effect->id, effect->replay.length);
  return 0;
}

int grab(int unit, bool wanted) {
  if (wanted && is_on(unit, k_grabbed)) {
    return refuse(EBUSY);
  }
  if (!wanted && !is_on(unit, k_grabbed)) {
    return refuse(EINVAL);
  }
  put(unit, k_grabbed, wanted ? 1.0 : 0.0);
  return 0;
}

}  // namespace

int answer_ioctl(int fd, int unit, unsigned long request, void* argument) {
  const std::size_t room = _IOC_SIZE(request);
  const unsigned number = _IOC_NR(request);
  if (!is_there(fd)) {
    return refuse(ENODEV);
  }
  if (_IOC_TYPE(request) != 'E') {
    return refuse(ENOTTY);
  }
  if (_IOC_DIR(request) == _IOC_READ) {
    if (number >= 0x20 && number < 0x20 + EV_CNT) {
      return what_it_has(unit, number - 0x20, argument, room);
    }
    if (number >= 0x40 && number < 0x40 + ABS_CNT) {
      return where_axis_is(unit, number - 0x40, argument, room);
    }
    switch (number) {
      case _IOC_NR(EVIOCGVERSION): {
        const int version = EV_VERSION;
        copy_out(argument, room, &version, sizeof(version));
        return 0;
      }
      case _IOC_NR(EVIOCGID):
        copy_out(argument, room, &pad_of(unit).id, sizeof(input_id));
        return 0;
      case _IOC_NR(EVIOCGNAME(0)):
        return copy_text(argument, room, pad_of(unit).name);
      case _IOC_NR(EVIOCGPHYS(0)):
        return copy_text(argument, room, ("usb-standin/input" + std::to_string(unit)).c_str());
      case _IOC_NR(EVIOCGUNIQ(0)):
        return refuse(ENOENT);
      case _IOC_NR(EVIOCGPROP(0)):
        return copy_bits(argument, room, Bits(), INPUT_PROP_CNT);
      case _IOC_NR(EVIOCGKEY(0)):
        return what_is_pressed(unit, argument, room);
      case _IOC_NR(EVIOCGLED(0)):
      case _IOC_NR(EVIOCGSND(0)):
      case _IOC_NR(EVIOCGSW(0)):
        return copy_bits(argument, room, Bits(), 64);
      case _IOC_NR(EVIOCGEFFECTS): {
        const int count = pad_of(unit).has_rumble ? kEffects : 0;
        copy_out(argument, room, &count, sizeof(count));
        return 0;
      }
      default:
        return refuse(EINVAL);
    }
  }
  switch (request) {
    case EVIOCSFF:
      return upload(fd, unit, static_cast<ff_effect*>(argument));
    case EVIOCRMFF:
      tell_process(fd, kEffectErase, static_cast<int>(reinterpret_cast<std::intptr_t>(argument)),
                   0);
      return 0;
    case EVIOCGRAB:
      return grab(unit, argument != nullptr);
    case EVIOCSCLOCKID: {
      const int clock = *static_cast<const int*>(argument);
      if (clock != CLOCK_REALTIME && clock != CLOCK_MONOTONIC && clock != CLOCK_BOOTTIME) {
        return refuse(EINVAL);
      }
      put(unit, k_clock_id, clock == CLOCK_REALTIME ? 0.0 : 1.0);
      return 0;
    }
    default:
      return refuse(EINVAL);
  }
}

}  // namespace standin
