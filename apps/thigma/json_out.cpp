#include "json_out.h"

#include <cmath>
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

nlohmann::ordered_json quantiles_json(const DurationSummary& durations, double unit,
                                      bool has_tail) {
  const auto number = [&](double seconds) {
    const double value = seconds / unit;
    const bool is_known = durations.count > 0 && std::isfinite(value);
    return is_known ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  nlohmann::ordered_json json;
  json["p50"] = number(durations.p50);
  json["p99"] = number(durations.p99);
  if (has_tail) json["p999"] = number(durations.p999);
  if (has_tail) json["p9999"] = number(durations.p9999);
  json["max"] = number(durations.max);
  return json;
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
