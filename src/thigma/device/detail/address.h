#pragma once
// Text of device addresses: "name=value&name=value", numbers, nearest names.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace thigma::detail {

/// Splits a query in order. Throws DeviceAddressError for a part without "=", an empty or a
/// repeated name.
std::vector<std::pair<std::string, std::string>> split_query(std::string_view query,
                                                             const std::string& scheme);

/// The finite number `text` is, wholly; throws DeviceAddressError naming `name` otherwise.
double parse_value(const std::string& scheme, const std::string& name, const std::string& text);

/// "1" or "0"; throws DeviceAddressError otherwise.
bool parse_flag(const std::string& scheme, const std::string& name, const std::string& value);

/// The name or address of a machine: letters, digits and . - _ : [ ] %, as it is sent and said as
/// it stands; throws DeviceAddressError otherwise.
std::string parse_host(const std::string& scheme, const std::string& name, const std::string& text);

/// Throws DeviceAddressError that says which of `names` is nearest to `name`.
[[noreturn]] void unknown_name(const std::string& scheme, const std::string& name,
                               const std::vector<std::string_view>& names);

/// 'text', at most the first 60 characters of it.
std::string quoted(std::string_view text);

/// Shortest decimal text that reads back as `value`.
std::string shortest(double value);

/// The one of `names` with the fewest edits from `text`; the first of equals. names is not empty.
std::string_view nearest_name(std::string_view text, const std::vector<std::string_view>& names);

}  // namespace thigma::detail
