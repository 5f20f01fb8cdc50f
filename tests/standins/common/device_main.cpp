// standin_device BOARD: the device as a process of its own, so that it goes on when its client is
// killed.
#include <cstdio>

#include "board.h"
#include "device.h"
#include <fcntl.h>
#include <unistd.h>

int main(int count, char** arguments) {
  int inherited = -1;
  standin::Board* board = count == 2 ? standin::open_board(arguments[1], &inherited) : nullptr;
  if (board == nullptr) {
    std::fprintf(stderr,
                 "standin_device BOARD: the file of a board, expected one that can be written\n");
    return 2;
  }
  const pid_t child = fork();  // the client waits for the parent only
  if (child != 0) {
    return child > 0 ? 0 : 1;
  }
  setsid();
  const int nothing = open("/dev/null", O_RDWR);
  for (int fd = 0; fd < 3; ++fd) {
    dup2(nothing, fd);
  }
  standin::use_board(board);
  board->device.store(getpid());
  standin::run_device(true);
  board->device.store(0);
  return 0;
}
