// thigma doctor: what this machine grants a real-time program, and how to get the rest.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "json_out.h"
#include "verbs.h"
#include <nlohmann/json.hpp>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include "thigma/depth/gpu_depth.h"
#include "thigma/device/open_device.h"
#include "thigma/session/rt_thread.h"

namespace thigma::app {
namespace {

enum class CheckState { ok, warn, missing };

struct Check {
  const char* name;
  CheckState state;
  std::string found;  // with its unit
  std::string fix;    // one sentence; "" when ok
};

const char* state_name(CheckState state) {
  switch (state) {
    case CheckState::ok:
      return "ok";
    case CheckState::warn:
      return "warn";
    case CheckState::missing:
      return "missing";
  }
  return "";
}

nlohmann::ordered_json text_or_null(const std::string& text) {
  return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

Check made(const char* name, bool is_ok, CheckState otherwise, std::string found, const char* fix) {
  return {name, is_ok ? CheckState::ok : otherwise, std::move(found), is_ok ? "" : fix};
}

std::string first_line(const char* path) {
  std::string line;
  std::ifstream file(path);
  std::getline(file, line);
  return line;
}

std::string number(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g %s", value, unit);
  return text;
}

Check check_cores() {
  const unsigned cores = std::thread::hardware_concurrency();
  return made("cores", cores >= 2, CheckState::warn, std::to_string(cores),
              "Give the machine at least two cores: one for the haptic thread, one for the contact "
              "thread.");
}

Check check_fifo() {
  RtGrant grant;
  std::thread probe([&grant] { grant = request_real_time({.priority = 80, .cpu = -1}); });
  probe.join();
  return made("sched_fifo", grant.is_fifo, CheckState::missing,
              grant.is_fifo ? "priority 80 granted" : grant.refused,
              "Add the line `YOUR_USER - rtprio 95` to /etc/security/limits.d/thigma.conf and log "
              "in again, "
              "or run as root.");
}

// By trying: neither the limit nor being root tells, in a container.
Check check_memlock() {
  rlimit limit{};
  const bool is_known = getrlimit(RLIMIT_MEMLOCK, &limit) == 0;
  const std::string refused = lock_process_memory();
  munlockall();
  std::string found = "limit unknown";
  if (is_known && limit.rlim_cur == RLIM_INFINITY) found = "limit unlimited";
  if (is_known && limit.rlim_cur != RLIM_INFINITY) {
    found = "limit " + std::to_string(limit.rlim_cur / 1024) + " KiB";
  }
  found += refused.empty() ? ", locking granted" : ", " + refused;
  return made("memlock", refused.empty(), CheckState::missing, found,
              "Add the line `YOUR_USER - memlock unlimited` to /etc/security/limits.d/thigma.conf "
              "and log in "
              "again, or run as root.");
}

Check check_clock_source() {
  const std::string source =
      first_line("/sys/devices/system/clocksource/clocksource0/current_clocksource");
  if (source.empty()) {
    return {"clock_source", CheckState::missing, "unknown",
            "Mount /sys, so that the clock source can be read."};
  }
  const bool is_slow =
      source == "hpet" || source == "acpi_pm" || source == "jiffies" || source == "pit";
  return made(
      "clock_source", !is_slow, CheckState::warn, source,
      "Start the kernel with clocksource=tsc: reading this clock costs a microsecond or more.");
}

Check check_resolution() {
  timespec step{};
  clock_getres(CLOCK_MONOTONIC, &step);
  const double resolution_ns =
      1e9 * static_cast<double>(step.tv_sec) + static_cast<double>(step.tv_nsec);
  constexpr int kReads = 20000;
  const std::int64_t start = monotonic_ns();
  std::int64_t last = start;
  for (int i = 0; i < kReads; ++i) last = monotonic_ns();
  const double cost_ns = static_cast<double>(last - start) / kReads;
  return made("monotonic_clock", resolution_ns <= 1000.0 && cost_ns <= 1000.0, CheckState::warn,
              number(resolution_ns, "ns resolution, ") + number(cost_ns, "ns a reading"),
              "Use a kernel with high-resolution timers and a clock source that needs no system "
              "call (tsc).");
}

Check check_governor() {
  const std::string governor = first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  if (governor.empty()) return {"cpu_governor", CheckState::ok, "not adjustable here", ""};
  return made("cpu_governor", governor == "performance", CheckState::warn, governor,
              "Run `cpupower frequency-set -g performance`: a sleeping processor wakes late.");
}

Check check_wake_up() {
  constexpr int kTicks = 500;
  std::vector<double> late_us;
  late_us.reserve(kTicks);
  // The timer itself; a session polls before each deadline and so hides lateness up to 250 us.
  DeadlineClock clock = clock_of(1000.0, 0.0);
  std::thread probe([&] {
    request_real_time({.priority = 80, .cpu = -1});
    start_clock(clock);
    for (int i = 0; i < kTicks; ++i)
      late_us.push_back(1e-3 * static_cast<double>(wait_for_tick(clock)));
  });
  probe.join();
  std::sort(late_us.begin(), late_us.end());
  const double p99 = late_us[static_cast<std::size_t>(0.99 * kTicks)];
  char found[160];
  std::snprintf(found, sizeof found,
                "p50 %.1f us, p99 %.1f us, max %.1f us, %llu of %d ticks missed",
                late_us[kTicks / 2], p99, late_us.back(),
                static_cast<unsigned long long>(clock.missed), kTicks);
  return made(
      "wake_up_1khz", p99 <= 150.0 && clock.missed == 0, CheckState::warn, found,
      "Stop other programs, allow SCHED_FIFO, and prefer a machine of your own to a virtual one.");
}

Check check_writable(const char* name, const std::filesystem::path& folder) {
  const bool is_writable = access(folder.c_str(), W_OK) == 0;
  return made(name, is_writable, CheckState::missing,
              folder.string() + (is_writable ? "" : " cannot be written"),
              "Change to a folder you may write to; recordings and results go there.");
}

Check check_shared() {
  const char* named = std::getenv("THIGMA_SHARED");
  const std::filesystem::path folder = named != nullptr && *named != '\0' ? named : "../shared";
  std::error_code ignored;
  const bool is_there = std::filesystem::is_directory(folder / "meshes", ignored);
  return made("shared_folder", is_there, CheckState::missing,
              folder.string() + (is_there ? "" : " is not there"),
              "Set THIGMA_SHARED to the folder of shared meshes; only tests and experiments on "
              "them need it.");
}

Check check_graphics() {
  const GpuDepth gpu = make_gpu_depth({});
  std::string found = gpu.is_on_gpu ? gpu.renderer : "none: " + gpu.reason;
  if (gpu.is_on_gpu && gpu.is_software) found += ", a renderer in software";
  return made("graphics_processor", gpu.is_on_gpu && !gpu.is_software, CheckState::warn, found,
              "Install a driver with EGL and OpenGL 4.3 if textures are to use depth = \"gpu\"; "
              "without one this processor computes them.");
}

Check check_devices() {
  std::string found;
  for (const DeviceScheme& scheme : device_schemes()) {
    for (const std::string& address : plugged_devices(scheme.scheme))
      found += (found.empty() ? "" : ", ") + address;
  }
  const bool is_any = !found.empty();
  return made(
      "devices", is_any, CheckState::warn, is_any ? found : "none plugged in",
      "Plug one in, or use the page's mouse; `thigma devices` names what each lacks and the "
      "step that mends it.");
}

int examine(const Common& common) {
  std::error_code error;
  const auto temporary = std::filesystem::temp_directory_path(error);
  const Check checks[] = {check_cores(),
                          check_fifo(),
                          check_governor(),
                          check_clock_source(),
                          check_resolution(),
                          check_wake_up(),
                          check_writable("working_folder", std::filesystem::current_path(error)),
                          check_writable("temporary_folder", error ? "/tmp" : temporary),
                          check_shared(),
                          check_graphics(),
                          check_devices(),
                          check_memlock()};
  for (const Check& check : checks) {
    if (common.json) {
      const nlohmann::ordered_json line = {{"check", check.name},
                                           {"state", state_name(check.state)},
                                           {"found", check.found},
                                           {"fix", text_or_null(check.fix)}};
      print_json(line);
    } else {
      std::printf("%-8s %-17s %s\n", state_name(check.state), check.name, check.found.c_str());
      if (!check.fix.empty()) std::printf("%-26s -> %s\n", "", check.fix.c_str());
    }
  }
  std::cout << std::flush;
  return kDone;
}

}  // namespace

void add_doctor(CLI::App& app, Common& common) {
  add_verb(app, common, "doctor",
           "check real-time permissions, clocks and folders; say how to fix what is missing",
           [&common] { return examine(common); });
}

}  // namespace thigma::app
