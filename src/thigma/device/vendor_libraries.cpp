#include "thigma/device/vendor_libraries.h"

#include "thigma/core/shared_library.h"

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

constexpr const char* kSpacenavNames[] = {"libspnav.so.0", "libspnav.so"};
constexpr const char* kSpacenavSymbols[] = {"spnav_open", "spnav_close", "spnav_poll_event"};

constexpr VendorLibrary kLibraries[] = {
    {"openhaptics:", "3D Systems Touch, Phantom (OpenHaptics)", kHdNames, kHdSymbols,
     "Install the Touch driver and OpenHaptics for Linux from 3D Systems, then run ldconfig."},
    {"dhd:", "Force Dimension omega, delta, sigma, lambda; Novint Falcon", kDhdNames, kDhdSymbols,
     "Install the Force Dimension SDK and copy its shared libraries to /usr/local/lib, then run "
     "ldconfig."},
    {"spacenav:", "3Dconnexion SpaceMouse (no force)", kSpacenavNames, kSpacenavSymbols,
     "Install the Debian packages libspnav0 and spacenavd."},
};

}  // namespace

std::span<const VendorLibrary> vendor_libraries() THIGMA_RT { return kLibraries; }

LibraryProbe probe_library(const VendorLibrary& library) {
  LibraryProbe probe;
  const auto opened = SharedLibrary::open(library.names, &probe.reason);
  if (!opened) return probe;
  probe.name = opened->name();
  const char* lacks = opened->first_missing(library.symbols);
  probe.state = lacks == nullptr ? LibraryState::loadable : LibraryState::incomplete;
  probe.reason = lacks == nullptr ? "" : "lacks the symbol " + std::string(lacks);
  return probe;
}

}  // namespace thigma
