#include "thigma/device/detail/device_profile.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma::detail {
namespace {

constexpr std::string_view kHead = "# thigma device profile\n";
constexpr std::string_view kTorqueUnit = "torque_unit = ";

std::string user_folder() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && config[0] == '/') return std::string(config) + "/thigma/devices";
  const char* home = std::getenv("HOME");
  return home != nullptr && home[0] == '/' ? std::string(home) + "/.config/thigma/devices" : "";
}

bool is_kept(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
}

}  // namespace

std::string device_profile_file(std::string_view name) {
  const std::string folder = user_folder();
  if (folder.empty()) return "";
  std::string word(name);
  std::replace_if(
      word.begin(), word.end(), [](char c) { return !is_kept(c); }, '-');
  return folder + "/" + word + ".txt";
}

DeviceProfile read_device_profile(const std::string& file) {
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) return {};
  const std::string text = read_file(file);
  // Written by write_device_profile and nothing else: a wrong unit is a thousandfold torque.
  for (const double unit : {1.0, 1000.0}) {
    const std::string line =
        std::string(kHead) + std::string(kTorqueUnit) + (unit == 1.0 ? "1\n" : "1000\n");
    if (text == line) return {unit};
  }
  throw InputError(file + ": no device profile, expected '" +
                   std::string(kHead.substr(0, kHead.size() - 1)) +
                   "' and torque_unit = 1 or 1000; delete it and calibrate again");
}

void write_device_profile(const std::string& file, const DeviceProfile& profile) {
  if (file.empty()) throw IoError("no home folder to keep a device profile in, set HOME");
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError(folder.string() + ": " + error.message());
  write_file(file, std::string(kHead) + std::string(kTorqueUnit) +
                       (profile.torque_unit == 1.0 ? "1\n" : "1000\n"));
}

}  // namespace thigma::detail
