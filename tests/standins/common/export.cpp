#include "export.h"

#include <limits>

#include "board.h"
#include "device.h"

int standin_set(const char* key, double value) {
  int unit = -1;
  const int number = standin::find_key(key, &unit);
  if (number < 0) {
    return -1;
  }
  for (int u = 0; u < standin::kUnits; ++u) {
    if (unit < 0 || unit == u) {
      standin::put(u, static_cast<standin::Key>(number), value);
    }
  }
  return 0;
}

double standin_get(const char* key) {
  int unit = -1;
  const int number = standin::find_key(key, &unit);
  if (number < 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return standin::get(unit < 0 ? 0 : unit, static_cast<standin::Key>(number));
}

int standin_log(const char* path) { return standin::write_log(path) ? 0 : -1; }

void standin_reset() { standin::reset_device(); }
