#include "thigma/device/detail/address.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "thigma/core/edit_distance.h"
#include "thigma/core/one_line.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
std::vector<std::pair<std::string, std::string>> split_query(std::string_view query,
                                                             const std::string& scheme) {
  std::vector<std::pair<std::string, std::string>> parts;
  for (std::size_t begin = 0; !query.empty() && begin <= query.size();) {
    const std::size_t end = std::min(query.find('&', begin), query.size());
    const std::string_view part = query.substr(begin, end - begin);
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      throw DeviceAddressError(scheme + " " + quoted(part) + ", expected name=value");
    }
    std::string name(part.substr(0, equals));
    for (const auto& [other, value] : parts) {
      if (other == name)
        throw DeviceAddressError(scheme + " " + quoted(name) + " is given twice, expected once");
    }
    parts.emplace_back(std::move(name), std::string(part.substr(equals + 1)));
    begin = end + 1;
  }
  return parts;
}

double parse_value(const std::string& scheme, const std::string& name, const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) {
    throw DeviceAddressError(scheme + " " + name + " = " + quoted(text) +
                             ", expected a finite number");
  }
  return value;
}

std::string parse_host(const std::string& scheme, const std::string& name,
                       const std::string& text) {
  constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_:[]%";
  if (text.empty() || text.find_first_not_of(kLetters) != std::string::npos) {
    throw DeviceAddressError(scheme + " " + name + " = " + quoted(text) +
                             ", expected the name or address of a machine");
  }
  return text;
}

std::string quoted(std::string_view text) {
  std::string result(1, '\'');
  result += one_line(std::string(text.substr(0, 60)));
  result += '\'';
  return result;
}

std::string shortest(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return error == std::errc() ? std::string(text, end) : std::string("?");
}

std::string_view nearest_name(std::string_view text, const std::vector<std::string_view>& names) {
  std::string_view nearest = names.front();
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  const std::string_view begin = text.substr(0, 64);
  for (const std::string_view name : names) {
    // So many edits it takes at least.
    const auto [fewer, more] = std::minmax({begin.size(), name.size()});
    if (more - fewer >= fewest) continue;
    const std::size_t edits = edit_distance(begin, name);
    if (edits < fewest) {
      fewest = edits;
      nearest = name;
    }
  }
  return nearest;
}

bool parse_flag(const std::string& scheme, const std::string& name, const std::string& value) {
  if (value == "1") return true;
  if (value == "0") return false;
  throw DeviceAddressError(scheme + " " + name + " = " + quoted(value) + ", expected 0 or 1");
}

void unknown_name(const std::string& scheme, const std::string& name,
                  const std::vector<std::string_view>& names) {
  throw DeviceAddressError(scheme + " no parameter " + quoted(name) + ", nearest is " +
                           quoted(nearest_name(name, names)));
}

}  // namespace thigma::detail
