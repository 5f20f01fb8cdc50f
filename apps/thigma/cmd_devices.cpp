// thigma devices: what `run --device` can open here, what is plugged in, and which vendor's library
// is missing; a device looked at (check) and set up (calibrate).

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "check_text.h"
#include "device_errors.h"
#include "json_out.h"
#include "run_options.h"
#include "signal_guard.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/device/open_device.h"
#include "thigma/device/vendor_libraries.h"

namespace thigma::app {
namespace {

const char* state_name(LibraryState state) {
  switch (state) {
    case LibraryState::loadable:
      return "loadable";
    case LibraryState::incomplete:
      return "incomplete";
    case LibraryState::unusable:
      return "unusable";
    case LibraryState::missing:
      return "missing";
  }
  return "";
}

nlohmann::ordered_json text_or_null(std::string_view text) {
  return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

void print_schemes_json() {
  for (const DeviceScheme& scheme : device_schemes()) {
    std::string why;
    nlohmann::ordered_json line = {{"device", scheme.scheme}, {"meaning", scheme.meaning}};
    line["plugged_in"] = plugged_devices(scheme.scheme, &why);
    line["missing"] = text_or_null(why);
    line["if_killed"] = text_or_null(scheme.if_killed);
    line["parameters"] = nlohmann::ordered_json::array();
    for (const DeviceParameter& p : scheme.parameters) {
      line["parameters"].push_back({{"name", p.name},
                                    {"unit", p.unit},
                                    {"default", p.default_value},
                                    {"meaning", p.meaning}});
    }
    print_json(line);
  }
}

void print_libraries_json() {
  for (const VendorLibrary& library : vendor_libraries()) {
    const LibraryProbe probe = probe_library(library);
    const bool is_there = probe.state == LibraryState::loadable;
    const nlohmann::ordered_json line = {{"library", library.names.front()},
                                         {"device", library.scheme},
                                         {"product", library.product},
                                         {"state", state_name(probe.state)},
                                         {"found", text_or_null(probe.name)},
                                         {"reason", text_or_null(probe.reason)},
                                         {"fix", text_or_null(is_there ? "" : probe.fix)}};
    print_json(line);
  }
}

void print_schemes_text() {
  std::printf("Devices for `thigma run --device`:\n");
  for (const DeviceScheme& scheme : device_schemes()) {
    std::printf("\n%-13s %s\n", scheme.scheme.c_str(), scheme.meaning.c_str());
    std::string why;
    for (const std::string& address : plugged_devices(scheme.scheme, &why))
      std::printf("  plugged in: %s\n", address.c_str());
    if (!why.empty()) std::printf("  none: %s\n", why.c_str());
    if (!scheme.if_killed.empty())
      std::printf("  if this program is killed: %s\n", scheme.if_killed.c_str());
    for (const DeviceParameter& p : scheme.parameters) {
      std::printf("  %-22s %-12s %-10s %s\n", p.name.c_str(), p.default_value.c_str(),
                  p.unit.c_str(), p.meaning.c_str());
    }
  }
  std::printf("\nParameters: name, default, unit, meaning; as in hand:?force=2&delay=0.003\n");
}

void print_libraries_text() {
  std::printf("\nVendors' libraries:\n");
  for (const VendorLibrary& library : vendor_libraries()) {
    const LibraryProbe probe = probe_library(library);
    std::printf("  %-11s %s: %s%s\n", state_name(probe.state), library.names.front(),
                std::string(library.product).c_str(),
                probe.name.empty() ? "" : (", " + probe.name).c_str());
    if (probe.state == LibraryState::loadable) continue;
    if (probe.state != LibraryState::missing)
      std::printf("              %s\n", probe.reason.c_str());
    std::printf("              %s\n", probe.fix.c_str());
  }
}

int list_devices(const Common& common) {
  if (common.json) {
    print_schemes_json();
    print_libraries_json();
    std::cout << std::flush;
  } else {
    print_schemes_text();
    print_libraries_text();
  }
  return kDone;
}

struct CheckOptions {
  std::string uri;
  DeviceCheckParams params;
  bool is_strict = false;
  bool has_page = false;
  std::optional<std::uint16_t> port;
};

/// A box in the hand on the page, its sides 100 mm along x, 60 along y and 40 along z: which way
/// is which, seen while the handle is moved. Whatever is opened there, the device is sent zero.
int show_axes(const CheckOptions& options, const Common& common) {
  RunOptions run;
  run.object = "procedural:box?triangles=12";
  run.against = "procedural:plate?triangles=12";
  run.pose_text = "0,0,0.1,0,0,0,1";
  run.response = "penalty";
  run.resolution.is_exact = true;
  run.device = options.uri;
  run.rate = options.params.rate;
  run.port = options.port;
  run.sends_zero = true;
  return run_verb(run, common);
}

int check(const CheckOptions& options, const Common& common) {
  if (std::isnan(options.params.seconds) || std::isnan(options.params.rate)) {
    print_error("devices check: --duration and --rate must be numbers");
    return kUsage;
  }
  if (options.has_page) return show_axes(options, common);
  return with_device([&] {
    const std::unique_ptr<HapticDevice> device = open_device(options.uri);
    if (!common.quiet)
      std::fprintf(stderr, "%.3g s: nothing is sent but zero; move the handle, press its buttons\n",
                   options.params.seconds);
    const SignalGuard signals;
    const DeviceReport report = check_device(*device, options.params, &stop_requested);
    if (common.json) {
      print_json(check_json(options.uri, device->limits(), report));
    } else {
      std::printf("%s", check_text(device->limits(), report, options.is_strict).c_str());
    }
    flush_output();
    if (stop_requested) return kInterrupted;
    return options.is_strict && !report.is_conforming() ? kClaimFails : kDone;
  });
}

bool answers_yes(const std::string& question, bool says_yes) {
  std::fprintf(stderr, "%s [y/N] ", question.c_str());
  if (says_yes) return std::fprintf(stderr, "yes\n") > 0;
  std::string answer;
  return std::getline(std::cin, answer) && !answer.empty() &&
         (answer[0] == 'y' || answer[0] == 'Y');
}

int calibrate(const std::string& uri, bool says_yes, const Common& common) {
  return with_device([&]() -> int {
    // What a yes lets move is ended by Ctrl-C in order; the program, where it asks.
    std::optional<SignalGuard> signals;
    CalibrationTalk talk;
    talk.say = [&](const std::string& text) {
      if (!common.quiet) std::fprintf(stderr, "%s\n", text.c_str());
    };
    talk.confirm = [&](const std::string& question) {
      if (stop_requested) return false;
      signals.reset();
      const bool is_yes = answers_yes(question, says_yes);
      if (is_yes) signals.emplace();
      return is_yes;
    };
    talk.is_stopped = [] { return stop_requested.load(); };
    talk.is_answered = !says_yes;
    calibrate_device(uri, talk);
    return stop_requested ? kInterrupted : kDone;
  });
}

void add_check(CLI::App& devices, Common& common) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* verb =
      add_verb(devices, common, "check", "rates, noise, axes and buttons of a device; sends zero",
               [options, &common] { return check(*options, common); });
  verb->add_option("URI", options->uri, "device address, as of run --device")->required();
  verb->add_option("--duration", options->params.seconds, "how long [s]")
      ->capture_default_str()
      ->check(CLI::Range(0.05, 3600.0));
  verb->add_option("--rate", options->params.rate, "frames a second [Hz]")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1e5));
  verb->add_flag("--strict", options->is_strict, "exit 5 where a rule of drivers does not hold");
  CLI::Option* page = verb->add_flag("--page", options->has_page,
                                     "a box that follows the handle, on a page, until Ctrl-C");
  verb->add_option("--port", options->port, "of the page; otherwise any free one")->needs(page);
  page->excludes("--strict")->excludes("--duration");
}

void add_calibrate(CLI::App& devices, Common& common) {
  const auto uri = std::make_shared<std::string>();
  const auto says_yes = std::make_shared<bool>(false);
  CLI::App* verb = add_verb(devices, common, "calibrate",
                            "the vendor's own procedure, and the unit of a Phantom's torque",
                            [=, &common] { return calibrate(*uri, *says_yes, common); });
  verb->add_option("URI", *uri, "device address, as of run --device")->required();
  verb->add_flag("--yes", *says_yes, "answer every question with yes");
}

}  // namespace

void add_devices(CLI::App& app, Common& common) {
  CLI::App* verb =
      add_verb(app, common, "devices", "list, check and calibrate devices; vendors' libraries",
               [&app, &common] {
                 const bool is_list = app.get_subcommand("devices")->get_subcommands().empty();
                 return is_list ? list_devices(common) : common.exit_code;
               });
  verb->require_subcommand(0, 1);
  add_check(*verb, common);
  add_calibrate(*verb, common);
}

}  // namespace thigma::app
