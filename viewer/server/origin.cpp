#include "viewer/server/origin.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>

#include <arpa/inet.h>
#include <unistd.h>

namespace thigma::live {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_text(std::string_view a, std::string_view b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(),
                                            [](char x, char y) { return lower(x) == lower(y); });
}

bool is_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// A host without its port and brackets; "" where it is malformed.
std::string_view name_of(std::string_view host) {
  if (!host.empty() && host.front() == '[') {
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos) return {};
    const std::string_view rest = host.substr(end + 1);
    return rest.empty() || (rest.front() == ':' && is_port(rest.substr(1)))
               ? host.substr(1, end - 1)
               : std::string_view();
  }
  const std::size_t colon = host.find(':');
  if (colon == std::string_view::npos) return host;
  return is_port(host.substr(colon + 1)) ? host.substr(0, colon) : std::string_view();
}

/// The bytes of a numeric address: 4 of IPv4, 16 of IPv6, none of anything else.
std::string bytes_of(const std::string& address) {
  std::array<char, 16> bytes{};
  if (inet_pton(AF_INET, address.c_str(), bytes.data()) == 1) return {bytes.data(), 4};
  if (inet_pton(AF_INET6, address.c_str(), bytes.data()) == 1) return {bytes.data(), 16};
  return {};
}

std::string machine_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return {};
  return name.data();
}

}  // namespace

bool is_address(const std::string& address) { return !bytes_of(address).empty(); }

bool is_loopback_address(const std::string& address) {
  const std::string bytes = bytes_of(address);
  if (bytes.size() == 4) return bytes[0] == 127;
  return bytes == bytes_of("::1");
}

bool is_own_host(std::string_view host) {
  const std::string name(name_of(host));
  return !name.empty() && (is_address(name) || same_text(name, machine_name()));
}

std::string host_of(const std::string& address) {
  const std::string bytes = bytes_of(address);
  const bool is_any = !bytes.empty() && bytes.find_first_not_of('\0') == std::string::npos;
  const std::string machine = machine_name();
  if (is_any && !machine.empty()) return machine;
  return bytes.size() == 16 ? "[" + address + "]" : address;
}

std::string make_token() {
  std::random_device system;
  std::string token;
  for (int i = 0; i < 4; ++i) {
    std::array<char, 9> word{};
    std::snprintf(word.data(), word.size(), "%08x", static_cast<unsigned>(system()));
    token += word.data();
  }
  return token;
}

bool is_same_secret(std::string_view a, std::string_view b) {
  unsigned char difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < b.size(); ++i)
    difference |= static_cast<unsigned char>((i < a.size() ? a[i] : '\0') ^ b[i]);
  return difference == 0;
}

bool is_loopback_host(std::string_view host) {
  for (const std::string_view name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (!same_text(host.substr(0, name.size()), name)) continue;
    const std::string_view rest = host.substr(name.size());
    return rest.empty() || (rest.front() == ':' && is_port(rest.substr(1)));
  }
  return false;
}

bool is_own_origin(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  return same_text(origin.substr(0, std::min(origin.size(), kScheme.size())), kScheme) &&
         same_text(origin.substr(kScheme.size()), host) && !host.empty();
}

}  // namespace thigma::live
