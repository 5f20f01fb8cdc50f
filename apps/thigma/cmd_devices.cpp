// thigma devices: what `run --device` can open here, and which vendor's library is missing.

#include <cstdio>
#include <iostream>
#include <string>

#include "json_out.h"
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
    nlohmann::ordered_json line = {
        {"device", scheme.scheme}, {"available", scheme.available}, {"meaning", scheme.meaning}};
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
                                         {"fix", text_or_null(is_there ? "" : library.fix)}};
    print_json(line);
  }
}

void print_schemes_text() {
  std::printf("Devices for `thigma run --device`:\n");
  for (const DeviceScheme& scheme : device_schemes()) {
    std::printf("\n%-13s %s%s\n", scheme.scheme.c_str(), scheme.meaning.c_str(),
                scheme.available ? "" : " - not in this build");
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
    std::printf("              %s\n", std::string(library.fix).c_str());
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

}  // namespace

void add_devices(CLI::App& app, Common& common) {
  add_verb(app, common, "devices", "List devices, their parameters, and vendors' libraries",
           [&common] { return list_devices(common); });
}

}  // namespace thigma::app
