// Keys by name, from the environment, and the record as text.
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <string>

#include "board.h"

namespace standin {
namespace {

constexpr const char* kNames[] = {
#define STANDIN_KEY(name, value) #name,
    STANDIN_KEYS(STANDIN_KEY)
#undef STANDIN_KEY
};

void read_variable(const std::string& prefix, int key, int unit) {
  std::string name = prefix;
  for (const char* c = kNames[key]; *c != 0; ++c) {
    name += static_cast<char>(std::toupper(static_cast<unsigned char>(*c)));
  }
  const char* text = std::getenv(name.c_str());
  if (text != nullptr) {
    for (int u = 0; u < kUnits; ++u) {
      if (unit < 0 || unit == u) {
        put(u, static_cast<Key>(key), std::strtod(text, nullptr));
      }
    }
  }
}

}  // namespace

int find_key(const char* name, int* unit) {
  *unit = -1;
  if (name[0] >= '0' && name[0] < '0' + kUnits && name[1] == '.') {
    *unit = name[0] - '0';
    name += 2;
  }
  for (int i = 0; i < kKeyCount; ++i) {
    if (std::strcmp(name, kNames[i]) == 0) {
      return i;
    }
  }
  return -1;
}

void read_environment(const char* library) {
  const std::string prefix = std::string("STANDIN_") + library + "_";
  for (int key = 0; key < kKeyCount; ++key) {
    read_variable(prefix, key, -1);
    for (int unit = 0; unit < kUnits; ++unit) {
      read_variable(prefix + std::to_string(unit) + "_", key, unit);
    }
  }
}

bool write_log(const char* path) {
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) {
    return false;
  }
  for (int unit = 0; unit < kUnits; ++unit) {
    for (int key = 0; key < kKeyCount; ++key) {
      std::fprintf(file, "# %d.%s=%.17g\n", unit, kNames[key], get(unit, static_cast<Key>(key)));
    }
  }
  std::fprintf(file, "number,time,unit,call,code,v0,v1,v2,v3,v4,v5,v6\n");
  const std::uint64_t end = board().events.load();
  for (std::uint64_t i = end > kEvents ? end - kEvents : 0; i < end; ++i) {
    const Event& e = board().event[i % kEvents];
    std::fprintf(file, "%llu,%.9f,%d,%s,%d", static_cast<unsigned long long>(e.number), e.time,
                 e.unit, e.call, e.code);
    for (const double v : e.value) {
      std::fprintf(file, ",%.17g", v);
    }
    std::fputc('\n', file);
  }
  return std::fclose(file) == 0;
}

}  // namespace standin
