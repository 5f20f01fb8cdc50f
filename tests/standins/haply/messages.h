// What the Inverse Service says and what it understands: JSON of the forms 3.1 and 3.5.
#pragma once

#include <string>

namespace standin {

// The form of commands that this service reads: 31 "values", 35 "vector", 2 both.
int command_form();

// The first message after connecting: configuration, state and status of all that is plugged in.
std::string inventory(int session);
// Every later one: state and status.
std::string state_update();
// GET /version.
std::string version_answer();
// The channel of events, one of a device.
std::string device_event(const char* name, const char* level, int unit, const std::string& text);

// "049D" and the like; of the grip that belongs to a device.
std::string device_id(int unit);
std::string grip_id(int unit);

// What a client sent. Takes the commands, under the lock of the board. True where the answer is to
// be a full one (`session.force_render_full_state`).
bool obey(const std::string& message, int session);
// The session's connection is gone: its commands end.
void end_session(int session);

}  // namespace standin
