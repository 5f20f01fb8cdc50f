// standin_control BOARD set KEY VALUE | get KEY | log FILE | new: a board from outside of the
// client.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "board.h"
#include "export.h"

namespace {

int usage() {
  std::fprintf(stderr, "standin_control BOARD new | set KEY VALUE | get KEY | log FILE\n");
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    return usage();
  }
  int inherited = -1;
  standin::Board* board = standin::open_board(arguments[1], &inherited);
  if (board == nullptr) {
    std::fprintf(stderr, "%s: cannot be opened as a board\n", arguments[1]);
    return 1;
  }
  standin::use_board(board);
  const char* verb = arguments[2];
  if (std::strcmp(verb, "new") == 0) {
    return 0;
  }
  if (std::strcmp(verb, "set") == 0 && count == 5) {
    const double value = std::strtod(arguments[4], nullptr);
    {
      // Before it is set: what follows from it is then behind it in the record.
      const standin::Locked lock;
      standin::note(0, (std::string("control: ") + arguments[3]).c_str(), 0, &value, 1);
    }
    return standin_set(arguments[3], value) == 0 ? 0 : usage();
  }
  if (std::strcmp(verb, "get") == 0 && count == 4) {
    const double value = standin_get(arguments[3]);
    std::printf("%.17g\n", value);
    return 0;
  }
  if (std::strcmp(verb, "log") == 0 && count == 4) {
    return standin_log(arguments[3]) == 0 ? 0 : 1;
  }
  return usage();
}
