#pragma once
// Who may talk to the server: pages it has served itself, under a name of this machine; and who may
// do more than watch.

#include <string>
#include <string_view>

namespace thigma::live {

/// Whether a Host header names this machine by a loopback name, with or without a port: 127.0.0.1,
/// localhost or [::1]. A name that somebody else's DNS points here does not pass. The port is not
/// looked at, so that tunnels work.
bool is_loopback_host(std::string_view host);

/// Whether this is a numeric address, of IPv4 or IPv6.
bool is_address(const std::string& address);

/// Whether an address to bind to is of this machine alone: 127.0.0.0/8 or ::1.
bool is_loopback_address(const std::string& address);

/// Whether a Host header is a numeric address, or the name this machine gives itself, with or
/// without a port. Names that others make up point here only by their DNS, and a name is what that
/// needs.
bool is_own_host(std::string_view host);

/// A bound address as the host of a URL: this machine's name for those that stand for all of its
/// addresses, brackets about IPv6.
std::string host_of(const std::string& address);

/// 128 bits from the system, in hexadecimal.
/// Throws std::runtime_error where the system has none.
std::string make_token();

/// Whether two secrets are the same, in a time that does not tell how much of them is.
bool is_same_secret(std::string_view a, std::string_view b);

/// Whether a page of this origin came from the server that this Host header reached: http:// and
/// the same host and port, letter by letter but for case.
bool is_own_origin(std::string_view origin, std::string_view host);

}  // namespace thigma::live
