#include "field.h"

#include <cmath>

#include "../common/board.h"
#include "../common/device.h"
#include "wire.h"

namespace standin {
namespace {

constexpr std::size_t kFieldSize = 16 * 4;

Vec vec(Key first) {
  return {get(0, first), get(0, static_cast<Key>(first + 1)), get(0, static_cast<Key>(first + 2))};
}

// Force at the origin and its change with position, nothing beyond the radius.
Vec force_at(const Vec& position) {
  const Vec origin = vec(k_field_ox);
  Vec off{};
  for (int i = 0; i < 3; ++i) {
    off[i] = position[i] - origin[i];
  }
  if (!(norm(off) <= get(0, k_field_radius))) {
    add(0, k_outside_field);
    return {0, 0, 0};
  }
  Vec force = vec(k_field_fx);
  for (int i = 0; i < 3; ++i) {
    const Vec row = vec(static_cast<Key>(k_field_jxx + 3 * i));
    force[i] += row[0] * off[0] + row[1] * off[1] + row[2] * off[2];
  }
  return force;
}

}  // namespace

bool take_field(std::string_view payload) {
  if (payload.size() != kFieldSize) {
    add(0, k_bad_messages);
    note(0, "Force_Field: wrong length", static_cast<int>(payload.size()));
    return false;
  }
  std::size_t at = 0;
  double v[16];
  bool is_finite = true;
  for (double& value : v) {
    value = static_cast<double>(take_float(payload, &at));
    is_finite = is_finite && std::isfinite(value);
  }
  for (int i = 0; i < 3; ++i) {
    put(0, static_cast<Key>(k_field_ox + i), v[i]);
    put(0, static_cast<Key>(k_field_fx + i), v[3 + i]);
    put(0, static_cast<Key>(k_last_fx + i), v[3 + i]);
  }
  for (int i = 0; i < 9; ++i) {
    put(0, static_cast<Key>(k_field_jxx + i), v[6 + i]);
  }
  put(0, k_field_radius, v[15]);
  put(0, k_field_active, 1.0);
  put(0, k_force_max, std::fmax(get(0, k_force_max), norm({v[3], v[4], v[5]})));
  put(0, k_last_set_time, now());
  add(0, k_fields);
  add(0, k_sets);
  if (!is_finite) {
    add(0, k_non_finite);
  }
  const double told[7] = {v[3], v[4], v[5], v[0], v[1], v[2], v[15]};
  note(0, "Force_Field", is_finite ? 0 : -1, told, 7);
  put(0, k_mode, kForce);
  return true;
}

void drop_field(const char* why) {
  put(0, k_field_active, 0.0);
  forces_off(0, kIdle, kSoftware, why);
}

int feel_field() {
  if (!is_on(0, k_field_active) || mode_of(0) != kForce) {
    return -1;
  }
  Vec force = force_at({get(0, k_px), get(0, k_py), get(0, k_pz)});
  const double most = get(0, k_max_force);
  const bool is_too_large = most > 0.0 && norm(force) > most;
  if (is_too_large) {
    const double scale = most / norm(force);
    for (double& f : force) {
      f *= scale;
    }
    add(0, k_saturations);
  }
  apply(0, force, {0, 0, 0});
  return is_too_large ? kForceError : -1;
}

}  // namespace standin
