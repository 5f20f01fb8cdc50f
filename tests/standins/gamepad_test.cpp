// Gamepads, pretended, as the kernel shows them: the library's calls, and a program under it.
#include <cerrno>
#include <cstring>

#include "services.h"
#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <sys/stat.h>

namespace standin_test {
namespace {

// The calls that LD_PRELOAD would put in front of the C library's, taken by name.
const Library& kernel() {
  static const Library library(".", "libstandin_evdev.so");
  return library;
}

bool has_bit(const unsigned char* bits, int bit) { return (bits[bit / 8] >> (bit % 8) & 1) != 0; }

class Gamepad : public ::testing::Test {
 protected:
  Gamepad() : pads("standin_gamepad", "GAMEPAD", {"--socket", folder()}) {
    setenv("STANDIN_GAMEPAD_BOARD", board().c_str(), 1);
    setenv("STANDIN_EVDEV_FOLDER", folder().c_str(), 1);
    // The library keeps the board of its first call, so the same name leads to each test's own.
    std::remove(board().c_str());
    EXPECT_EQ(link(pads.path().c_str(), board().c_str()), 0);
  }
  ~Gamepad() override { std::remove(board().c_str()); }

  static std::string folder() { return "/tmp/si_pads_" + std::to_string(getpid()); }
  static std::string board() { return folder() + ".board"; }

  static int open_pad(const char* node = "/dev/input/event0") {
    return kernel().call("open", node, O_RDWR | O_NONBLOCK);
  }
  template <class Argument>
  static int control(int fd, unsigned long request, Argument argument) {
    return kernel().call("ioctl", fd, request, argument);
  }
  // Waits for an event; nothing where none comes or the device is gone, which sets `error`.
  static input_event next(int fd, int* error = nullptr) {
    input_event e{};
    for (int i = 0; i < 5000; ++i) {
      const auto got = kernel().call<ssize_t>("read", fd, static_cast<void*>(&e), sizeof(e));
      if (got > 0) {
        return e;
      }
      if (errno != EAGAIN) {
        break;
      }
      usleep(1000);
    }
    if (error != nullptr) {
      *error = errno;
    }
    return {};
  }

  Running pads;
};

// One process has one library, which keeps its board: everything that asks through it is here.
TEST_F(Gamepad, answers_as_the_kernel_does) {
  ASSERT_TRUE(kernel().is_open()) << dlerror();
  const int fd = open_pad();
  ASSERT_GE(fd, 0) << std::strerror(errno);

  char name[64] = {};
  EXPECT_EQ(control(fd, EVIOCGNAME(sizeof(name)), name), 24);
  EXPECT_STREQ(name, "Microsoft X-Box 360 pad");
  input_id id{};
  EXPECT_EQ(control(fd, EVIOCGID, &id), 0);
  EXPECT_EQ(id.vendor, 0x045e);
  unsigned char bits[96] = {};
  EXPECT_GT(control(fd, EVIOCGBIT(EV_KEY, sizeof(bits)), bits), 0);
  EXPECT_TRUE(has_bit(bits, BTN_SOUTH));
  EXPECT_FALSE(has_bit(bits, KEY_A));
  input_absinfo info{};
  EXPECT_EQ(control(fd, EVIOCGABS(ABS_RX), &info), 0);
  EXPECT_EQ(info.minimum, -32768);
  EXPECT_EQ(info.maximum, 32767);
  EXPECT_EQ(control(fd, EVIOCGABS(ABS_WHEEL), &info), -1);
  EXPECT_EQ(control(fd, _IOR('X', 1, int), &info), -1);
  EXPECT_EQ(errno, ENOTTY);

  pads.set("axis_rx", -20000);
  pads.set("buttons", 2);
  int seen = 0;
  for (input_event e = next(fd); seen < 2 && e.type != 0x7777; e = next(fd)) {
    if (e.type == EV_ABS && e.code == ABS_RX) {
      EXPECT_EQ(e.value, -20000);
      ++seen;
    } else if (e.type == EV_KEY) {
      EXPECT_EQ(e.code, BTN_EAST);
      EXPECT_EQ(e.value, 1);
      ++seen;
    }
  }
  EXPECT_EQ(control(fd, EVIOCGABS(ABS_RX), &info), 0);
  EXPECT_EQ(info.value, -20000);
  std::memset(bits, 0, sizeof(bits));
  EXPECT_GT(control(fd, EVIOCGKEY(sizeof(bits)), bits), 0);
  EXPECT_TRUE(has_bit(bits, BTN_EAST));

  input_event small{};
  EXPECT_EQ(kernel().call<ssize_t>("read", fd, static_cast<void*>(&small), std::size_t{8}), -1);
  EXPECT_EQ(errno, EINVAL);

  pads.set("unplug", 1);
  int error = 0;
  while (next(fd, &error).type != 0 || error == 0) {
  }
  EXPECT_EQ(error, ENODEV);
  EXPECT_EQ(control(fd, EVIOCGID, &id), -1);
  EXPECT_EQ(errno, ENODEV);
  kernel().call("close", fd);
  EXPECT_EQ(open_pad(), -1);
  EXPECT_EQ(errno, ENOENT);
  pads.set("unplug", 0);
  ASSERT_TRUE(wait_for([] { return access((folder() + "/event0").c_str(), F_OK) == 0; }));

  pads.set("no_permission", 1);
  EXPECT_EQ(open_pad(), -1);
  EXPECT_EQ(errno, EACCES);
  EXPECT_EQ(kernel().call("access", "/dev/input/event0", R_OK), -1);
  pads.set("no_permission", 0);
  struct stat status {};
  EXPECT_EQ(kernel().call("stat", "/dev/input/event0", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));

  // The device is there before somebody answers for it.
  int shaken = -1;
  ASSERT_TRUE(wait_for([&] {
    shaken = open_pad();
    return shaken >= 0;
  })) << std::strerror(errno);
  ff_effect effect{};
  effect.type = FF_RUMBLE;
  effect.id = -1;
  effect.u.rumble.strong_magnitude = 0x8000;
  effect.u.rumble.weak_magnitude = 0x4000;
  EXPECT_EQ(control(shaken, EVIOCSFF, &effect), 0);
  EXPECT_GE(effect.id, 0);
  input_event play{};
  play.type = EV_FF;
  play.code = static_cast<std::uint16_t>(effect.id);
  play.value = 1;
  EXPECT_EQ(kernel().call<ssize_t>("write", shaken, static_cast<const void*>(&play), sizeof(play)),
            24);
  EXPECT_TRUE(pads.reaches("rumble_on", 1));
  EXPECT_EQ(pads.get("rumble_strong"), 0x8000);
  EXPECT_EQ(pads.get("rumble_weak"), 0x4000);
  kernel().call("close", shaken);  // as at the death of a process
  EXPECT_TRUE(pads.reaches("rumble_on", 0));
  EXPECT_NE(pads.log().find("closed, effects erased"), std::string::npos);
}

class PadProgram : public Gamepad {
 protected:
  // What standin_pad_client says with the library in front of the C library.
  std::string run(const std::string& arguments, const std::function<void()>& meanwhile) const {
    const std::string command = "ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=" STANDIN_FOLDER
                                "/libstandin_evdev.so " STANDIN_FOLDER "/standin_pad_client " +
                                arguments + " 2>&1";
    std::FILE* pipe = popen(command.c_str(), "r");
    meanwhile();
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
      text += static_cast<char>(c);
    }
    pclose(pipe);
    return text;
  }
};

TEST_F(PadProgram, finds_a_device_and_reads_it) {
  const std::string text = run("/dev/input/event0 3", [this] {
    EXPECT_TRUE(pads.reaches("clients", 1));
    pads.set("overrun", 1);
    EXPECT_TRUE(pads.reaches("overrun", 0));
    pads.set("hat_x", -1);
  });
  EXPECT_NE(text.find("/dev/input/event0 device\nMicrosoft X-Box 360 pad\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("0 3 0\n0 0 0\n3 16 -1\n"), std::string::npos) << text;  // SYN_DROPPED first
}

TEST_F(PadProgram, is_told_what_is_wrong) {
  pads.set("no_permission", 1);
  EXPECT_NE(run("/dev/input/event0 1", [] {}).find("open: Permission denied"), std::string::npos);
  pads.set("no_permission", 0);
  const std::string text = run("/dev/input/event0 1", [this] {
    EXPECT_TRUE(pads.reaches("clients", 1));
    pads.set("unplug", 1);
  });
  EXPECT_NE(text.find("read: No such device"), std::string::npos) << text;
}

TEST_F(PadProgram, a_keyboard_and_two_pads) {
  pads.set("count", 2);
  pads.set("1.not_a_pad", 1);
  pads.set("0.pad_type", 1);
  ASSERT_TRUE(wait_for([] { return access((folder() + "/event1").c_str(), F_OK) == 0; }));
  EXPECT_NE(run("/dev/input/event1 0", [] {}).find("keyboard"), std::string::npos);
  EXPECT_NE(run("/dev/input/event0 0", [] {}).find("DualSense"), std::string::npos);
}

TEST_F(PadProgram, killed_it_leaves_no_rumble) {
  // The kernel erases the effects of a file when it is closed, by whatever way.
  Wire wire(Wire::unix_socket(folder() + "/event0"));
  input_event records[3] = {};
  records[0].type = 0xF001;
  records[0].value = 0x70006000;
  records[1].type = 0xF002;
  records[1].value = 0;
  records[2].type = EV_FF;
  records[2].value = 1;
  wire.send({reinterpret_cast<const char*>(records), sizeof(records)});
  EXPECT_TRUE(pads.reaches("rumble_on", 1));
  EXPECT_EQ(pads.get("rumble_strong"), 0x7000);
  wire.close();
  EXPECT_TRUE(pads.reaches("rumble_on", 0));
}

}  // namespace
}  // namespace standin_test
