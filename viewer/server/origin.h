#pragma once
// Who may talk to the server: pages it has served itself, under a name of this machine.

#include <string_view>

namespace thigma::live {

/// Whether a Host header names this machine by a loopback name, with or without a port: 127.0.0.1,
/// localhost or [::1]. A name that somebody else's DNS points here does not pass. The port is not
/// looked at, so that tunnels work.
bool is_loopback_host(std::string_view host);

/// Whether a page of this origin came from the server that this Host header reached: http:// and
/// the same host and port, letter by letter but for case.
bool is_own_origin(std::string_view origin, std::string_view host);

}  // namespace thigma::live
