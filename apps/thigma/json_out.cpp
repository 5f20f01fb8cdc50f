#include "json_out.h"

#include <cstdio>
#include <iostream>

#include <poll.h>
#include <unistd.h>

namespace thigma::app {
namespace {

bool is_reader_gone() {
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void print_json(const nlohmann::ordered_json& json) {
  const std::string line = json_text(json) + "\n";
  std::fwrite(line.data(), 1, line.size(), stdout);
  if (std::ferror(stdout) != 0) flush_output();
}

void flush_output() {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout) return;
  if (is_reader_gone()) throw ReaderGone("standard output: nobody reads it any more");
  throw IoError("standard output: cannot be written");
}

}  // namespace thigma::app
