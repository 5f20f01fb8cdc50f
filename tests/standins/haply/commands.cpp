// What the service is sent. Commands last one message: who stops sending lets the device go idle.
#include <cmath>
#include <optional>

#include "../common/board.h"
#include "../common/device.h"
#include "messages.h"
#include <nlohmann/json.hpp>

namespace standin {
namespace {

using Json = nlohmann::json;

int commander[kUnits] = {};  // the session whose force a device has

int unit_of(const Json& entry) {
  const Json id = entry.value("device_id", Json());
  for (int unit = 0; unit < kUnits; ++unit) {
    if (id == device_id(unit) && unit < get(unit, k_count) && !is_on(unit, k_unplug)) {
      return unit;
    }
  }
  return -1;
}

std::optional<Vec> three(const Json& object, const char* const names[3]) {
  Vec v{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!object.is_object() || !object.contains(names[i]) || !object[names[i]].is_number()) {
      return std::nullopt;
    }
    v[i] = object[names[i]].get<double>();
  }
  return v;
}

constexpr const char* kAxes[3] = {"x", "y", "z"};
constexpr const char* kJoints[3] = {"a0", "a1", "a2"};

void complain(int unit, const char* what) {
  add(0, k_errors);
  note(unit < 0 ? 0 : unit, what, -1);
}

void send_force(int unit, const Vec& asked, int session) {
  Sent sent{"set_cursor_force", asked, {}, 0.0, 0};
  const bool moves = is_on(unit, k_calibrated) && is_on(unit, k_ready) && is_on(unit, k_powered) &&
                     !is_on(unit, k_cut) && std::isfinite(norm(asked));
  Vec force = asked;
  const double most = get(unit, k_max_force);
  if (moves && most > 0.0 && norm(asked) > most) {
    for (double& f : force) {
      f *= most / norm(asked);
    }
    add(unit, k_saturations);
    sent.code = 2;
  }
  if (!moves) {
    add(unit, k_set_while_off);
    sent.code = -1;
  } else if (mode_of(unit) != kForce) {
    put(unit, k_mode, kForce);
    note(unit, "device: control_mode force", 0);
  }
  advance(unit);
  record(unit, sent);
  if (moves) {
    apply(unit, force, {0, 0, 0});
    commander[unit] = session;
  }
}

// The vector of a force command, by the form that this version reads.
std::optional<Vec> force_of(const Json& command) {
  const int form = command_form();
  const char* mine = form == 31 ? "values" : "vector";
  const char* other = form == 31 ? "vector" : "values";
  if (command.contains(mine)) {
    return three(command[mine], kAxes);
  }
  if (command.contains(other)) {
    add(0, k_wrong_form);
    return form == 2 ? three(command[other], kAxes) : std::nullopt;
  }
  return std::nullopt;
}

void note_vector(int unit, const char* call, const Json& command, const char* field,
                 const char* const names[3], Key counter) {
  const std::optional<Vec> v =
      command.contains(field) ? three(command[field], names) : std::nullopt;
  add(unit, counter);
  note(unit, call, v ? 0 : -1, v ? v->data() : nullptr, v ? 3 : 0);
}

// True where a force keeps the device out of idle.
bool take_commands(int unit, const Json& commands, int session) {
  bool has_force = false;
  for (const auto& [name, command] : commands.items()) {
    if (name == "set_cursor_force") {
      const std::optional<Vec> force = command.is_object() ? force_of(command) : std::nullopt;
      if (!force) {
        complain(unit, "set_cursor_force: no force in it");
      } else if (command.value("execute", Json(true)) == false) {
        note(unit, "set_cursor_force: execute false", 0, force->data(), 3);
      } else {
        send_force(unit, *force, session);
        has_force = true;
      }
    } else if (name == "probe_position") {
      add(unit, k_probes);
    } else if (name == "set_angular_torques") {
      note_vector(unit, "set_angular_torques", command, "torques", kJoints, k_torque_sets);
      const std::optional<Vec> t =
          command.is_object() ? three(command.value("torques", Json()), kJoints) : std::nullopt;
      if (t && norm(*t) != 0.0) {
        add(unit, k_torque_nonzero);
      }
    } else if (name == "set_cursor_position") {
      note_vector(unit, "set_cursor_position", command, "position", kAxes, k_positions);
    } else if (name == "set_angular_position") {
      note_vector(unit, "set_angular_position", command, "angles", kJoints, k_positions);
    } else {
      note(unit, ("command " + name).substr(0, 39).c_str(), 0);
      add(unit, k_configures);
    }
  }
  return has_force;
}

void go_idle(int unit, const char* why) {
  if (mode_of(unit) == kForce) {
    advance(unit);
    forces_off(unit, kIdle, kSoftware, why);
    commander[unit] = 0;
  }
}

}  // namespace

bool obey(const std::string& message, int session) {
  const Locked lock;
  add(0, k_messages);
  const Json json = Json::parse(message, nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    add(0, k_bad_messages);
    complain(0, "invalid-io-channel");
    return false;
  }
  if (json.empty()) {
    add(0, k_keepalives);
  }
  bool is_forced[kUnits] = {};
  bool is_full = false;
  for (const auto& [name, value] : json.items()) {
    if (name == "session") {
      is_full = value.is_object() && value.contains("force_render_full_state");
      add(0, k_configures);
      const bool has_profile = value.is_object() && value.contains("configure") &&
                               value["configure"].is_object() &&
                               value["configure"].contains("profile");
      note(0, has_profile ? "session.configure.profile" : "session", session);
    } else if (name == "inverse3" && value.is_array()) {
      for (const Json& entry : value) {
        const int unit = entry.is_object() ? unit_of(entry) : -1;
        if (unit < 0) {
          complain(-1, "inverse3: no such device_id");
          continue;
        }
        if (entry.contains("configure")) {
          add(unit, k_configures);
          note(unit, "configure", 0);
        }
        const Json commands = entry.value("commands", Json::object());
        is_forced[unit] = commands.is_object() && take_commands(unit, commands, session);
      }
    } else if (name.find("verse_grip") == std::string::npos) {
      complain(-1, ("unknown key " + name).substr(0, 39).c_str());
    }
  }
  for (int unit = 0; unit < kUnits; ++unit) {
    if (!is_forced[unit] && commander[unit] == session) {
      go_idle(unit, "device: no command in this message");
    }
  }
  return is_full;
}

void end_session(int session) {
  const Locked lock;
  for (int unit = 0; unit < kUnits; ++unit) {
    if (commander[unit] == session) {
      go_idle(unit, "device: session closed");
    }
  }
}

}  // namespace standin
