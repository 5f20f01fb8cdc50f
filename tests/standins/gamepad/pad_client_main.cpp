// standin_pad_client NODE EVENTS: opens a gamepad as any program does, says its name and so many
// events. For the test of libstandin_evdev.so with LD_PRELOAD.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <linux/input.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "standin_pad_client NODE EVENTS\n");
    return 2;
  }
  for (const auto& entry : std::filesystem::directory_iterator("/dev/input")) {
    std::printf("%s %s\n", entry.path().c_str(),
                entry.is_character_file() ? "device" : "something else");
  }
  const int fd = open(arguments[1], O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) {
    std::printf("open: %s\n", std::strerror(errno));
    return 3;
  }
  char name[128] = {};
  ioctl(fd, EVIOCGNAME(sizeof(name)), name);
  std::printf("%s\n", name);
  std::fflush(stdout);
  for (int i = 0; i < std::atoi(arguments[2]); ++i) {
    pollfd waiting{fd, POLLIN, 0};
    poll(&waiting, 1, 10000);
    input_event e{};
    if (read(fd, &e, sizeof(e)) != static_cast<ssize_t>(sizeof(e))) {
      std::printf("read: %s\n", std::strerror(errno));
      return 3;
    }
    std::printf("%d %d %d\n", e.type, e.code, e.value);
    std::fflush(stdout);
  }
  close(fd);
  return 0;
}
