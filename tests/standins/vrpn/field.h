// The local field of forces that a client hands to the server, and what the handle feels of it.
#pragma once

#include <string_view>

namespace standin {

// Takes the payload of "vrpn_ForceDevice Force_Field"; false where its length is wrong. Under the
// lock of the board.
bool take_field(std::string_view payload);
// No force any more, and why.
void drop_field(const char* why);
// Lets motors do what the field says at the handle now; an error of the device or -1. Under the
// lock.
int feel_field();

// Errors that a force device tells its client.
enum ForceError { kOutOfRange = 0, kDutyCycle = 1, kForceError = 2, kMisc = 3 };

}  // namespace standin
