#include "thigma/device/vendor_libraries.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include <unistd.h>

#include "thigma/device/open_device.h"

namespace thigma {
namespace {

constexpr const char* kHdNames[] = {"libHD.so", "libHD.so.3.4", "/usr/lib/libHD.so"};
constexpr const char* kHdSymbols[] = {
    "hdInitDevice", "hdDisableDevice", "hdBeginFrame",           "hdEndFrame",
    "hdGetDoublev", "hdSetDoublev",    "hdScheduleAsynchronous", "hdUnschedule",
    "hdEnable",     "hdDisable",       "hdStartScheduler",       "hdStopScheduler"};

// libdrd holds every dhd symbol too; libdhd alone is enough to read and to send wrenches.
constexpr const char* kDhdNames[] = {"libdrd.so.3",
                                     "libdrd.so",
                                     "libdhd.so.3",
                                     "libdhd.so",
                                     "/usr/local/lib/libdrd.so.3",
                                     "/usr/local/lib/libdrd.so",
                                     "/usr/local/lib/libdhd.so.3",
                                     "/usr/local/lib/libdhd.so"};
constexpr const char* kDhdSymbols[] = {
    "dhdGetDeviceCount",    "dhdGetPositionAndOrientationFrame",
    "dhdGetLinearVelocity", "dhdGetAngularVelocityRad",
    "dhdGetButtonMask",     "dhdSetForceAndTorqueAndGripperForce",
    "dhdEnableForce",       "dhdStop"};

constexpr VendorLibrary kLibraries[] = {
    {"openhaptics:", "3D Systems Touch, Phantom (OpenHaptics)", kHdNames, kHdSymbols,
     "Install the Touch driver and OpenHaptics for Linux from 3D Systems, then run ldconfig."},
    {"dhd:", "Force Dimension omega, delta, sigma, lambda; Novint Falcon", kDhdNames, kDhdSymbols,
     "Install the Force Dimension SDK and copy its shared libraries to /usr/local/lib, then run "
     "ldconfig."},
};

/// Folders the loader looks into, as far as they matter for a better word than "no such file".
std::vector<std::string> library_folders() {
  std::vector<std::string> folders;
  if (const char* path = std::getenv("LD_LIBRARY_PATH")) {
    std::string rest = path;
    for (std::size_t colon; !rest.empty(); rest = rest.substr(colon + 1)) {
      colon = rest.find(':');
      folders.push_back(rest.substr(0, colon));
      if (colon == std::string::npos) break;
    }
  }
  for (const char* usual :
       {"/usr/local/lib", "/usr/lib", "/usr/lib/x86_64-linux-gnu", "/usr/lib64"})
    folders.emplace_back(usual);
  return folders;
}

/// The machine number of an ELF file's header, -1 where it is none.
int elf_machine(const std::string& file) {
  char head[20] = {};
  std::ifstream in(file, std::ios::binary);
  if (!in.read(head, sizeof head) || std::string_view(head, 4) !=
                                         "\x7f"
                                         "ELF")
    return -1;
  return static_cast<unsigned char>(head[18]) | static_cast<unsigned char>(head[19]) << 8;
}

/// Says what the loader does not: it passes over files that it may not read and over those of
/// another processor, and then says that there is no such file.
bool find_unusable(const std::string& name, LibraryProbe& probe) {
  const bool is_path = name.find('/') != std::string::npos;
  for (const std::string& folder : is_path ? std::vector<std::string>{""} : library_folders()) {
    const std::string file = is_path ? name : folder + "/" + name;
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) continue;
    if (access(file.c_str(), R_OK) != 0) {
      probe.reason = file + ": permission denied";
      probe.fix = "Let it be read: sudo chmod a+r " + file + ".";
      return true;
    }
    const int here = elf_machine("/proc/self/exe"), there = elf_machine(file);
    if (there >= 0 && here >= 0 && there != here) {
      probe.reason = file + ": is for another processor";
      probe.fix = "Install the vendor's libraries for this processor (x86-64).";
      return true;
    }
  }
  return false;
}

/// What mends a library that is there and does not open, from the loader's own words.
std::string mend(const std::string& name, const std::string& why) {
  const auto says = [&why](const char* text) { return why.find(text) != std::string::npos; };
  if (says("wrong ELF class") || says("invalid ELF header") || says("file too short"))
    return "Install the vendor's 64-bit libraries for this processor (x86-64) in its place.";
  if (says("Permission denied")) return "Let it be read: sudo chmod a+r on that file.";
  const std::string needed = why.substr(0, why.find(':'));
  if (says("cannot open shared object file") && needed != name)
    return "Install " + needed + ", which it needs, then run ldconfig.";
  return "Install the vendor's current version.";
}

/// Why a name did not open; false: there is no such file.
bool explain(const std::string& name, const std::string& why, LibraryProbe& probe) {
  const bool is_absent = why.rfind(name + ": cannot open shared object file: No such file", 0) == 0;
  if (is_absent) {
    if (!find_unusable(name, probe)) return false;
  } else {
    probe.reason = why;
    probe.fix = mend(name, why);
  }
  probe.state = LibraryState::unusable;
  probe.name = name;
  return true;
}

/// Opens the first name that does; else nothing, and why.
std::optional<SharedLibrary> open_library(const VendorLibrary& library, LibraryProbe& probe) {
  std::string absent;
  for (const char* name : library.names) {
    std::string why;
    auto opened = SharedLibrary::open({&name, 1}, &why);
    if (!opened) {
      if (explain(name, why, probe)) return std::nullopt;
      absent += (absent.empty() ? "" : "; ") + why;
      continue;
    }
    probe.name = name;
    const char* lacks = opened->first_missing(library.symbols);
    if (lacks == nullptr) {
      probe.state = LibraryState::loadable;
      return opened;
    }
    probe.state = LibraryState::incomplete;
    probe.reason = "lacks the symbol " + std::string(lacks);
    probe.fix = "Install the vendor's current version: this one is too old, or another library.";
    return std::nullopt;
  }
  probe.reason = absent;
  probe.fix = library.fix;
  return std::nullopt;
}

}  // namespace

std::span<const VendorLibrary> vendor_libraries() THIGMA_RT { return kLibraries; }

LibraryProbe probe_library(const VendorLibrary& library) {
  LibraryProbe probe;
  open_library(library, probe);
  return probe;
}

SharedLibrary open_vendor_library(std::string_view scheme) {
  for (const VendorLibrary& library : kLibraries) {
    if (library.scheme != scheme) continue;
    LibraryProbe probe;
    if (auto opened = open_library(library, probe)) return std::move(*opened);
    const std::string what = probe.state == LibraryState::missing
                                 ? "there is no " + std::string(library.names.front())
                                 : probe.name + " cannot be used (" + probe.reason + ")";
    throw DeviceUnavailable(std::string(scheme) + " " + what + ". " + probe.fix);
  }
  throw DeviceUnavailable(std::string(scheme) + " needs no library");
}

}  // namespace thigma
