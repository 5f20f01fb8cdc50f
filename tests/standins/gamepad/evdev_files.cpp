// What is asked of files in /dev/input by their paths: stat, access, listing; in front of the C
// library's, as evdev_preload.cpp.
#include <cerrno>
#include <cstring>
#include <string>

#include "../common/board.h"
#include "evdev.h"
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace standin {
namespace {

template <class Status>
int as_device(const std::string& path, int result, Status* status) {
  const int unit = unit_of_path(path);
  if (result == 0 && S_ISSOCK(status->st_mode) && unit >= 0) {
    const bool is_open = has_board() && !is_on(unit, k_no_permission);
    status->st_mode = S_IFCHR | (is_open ? 0660U : 0000U);
    status->st_rdev = makedev(kMajor, kMinor + static_cast<unsigned>(unit));
  }
  return result;
}

}  // namespace
}  // namespace standin

using namespace standin;

#define STANDIN_STAT(name, Status)                                               \
  STANDIN_CALL int name(const char* path, struct Status* status) noexcept {      \
    const std::string mine = ours(path);                                         \
    const auto really = next<int (*)(const char*, struct Status*)>(#name);       \
    return mine.empty() ? really(path, status)                                   \
                        : as_device(mine, really(mine.c_str(), status), status); \
  }
STANDIN_STAT(stat, stat)
STANDIN_STAT(lstat, stat)
STANDIN_STAT(stat64, stat64)
STANDIN_STAT(lstat64, stat64)

STANDIN_CALL int fstatat(int at, const char* path, struct stat* status, int flags) noexcept {
  const std::string mine = ours(path);
  const auto really = next<int (*)(int, const char*, struct stat*, int)>("fstatat");
  return mine.empty() ? really(at, path, status, flags)
                      : as_device(mine, really(at, mine.c_str(), status, flags), status);
}

STANDIN_CALL int statx(int at, const char* path, int flags, unsigned mask,
                       struct statx* status) noexcept {
  const std::string mine = ours(path);
  const auto really = next<int (*)(int, const char*, int, unsigned, struct statx*)>("statx");
  if (mine.empty()) {
    return really(at, path, flags, mask, status);
  }
  const int result = really(at, mine.c_str(), flags, mask, status);
  const int unit = unit_of_path(mine);
  if (result == 0 && S_ISSOCK(status->stx_mode) && unit >= 0) {
    const bool is_open = has_board() && !is_on(unit, k_no_permission);
    status->stx_mode = static_cast<std::uint16_t>(S_IFCHR | (is_open ? 0660U : 0U));
    status->stx_rdev_major = kMajor;
    status->stx_rdev_minor = kMinor + static_cast<unsigned>(unit);
  }
  return result;
}

STANDIN_CALL int access(const char* path, int mode) noexcept {
  const std::string mine = ours(path);
  const int unit = unit_of_path(mine);
  if (!mine.empty() && unit >= 0 && unit < kUnits && mode != F_OK && has_board() &&
      is_on(unit, k_no_permission)) {
    errno = EACCES;
    return -1;
  }
  return next<int (*)(const char*, int)>("access")(mine.empty() ? path : mine.c_str(), mode);
}

STANDIN_CALL DIR* opendir(const char* path) {
  const std::string mine = ours(path);
  return next<DIR* (*)(const char*)>("opendir")(mine.empty() ? path : mine.c_str());
}

// Sockets of the folder are character devices to a client.
STANDIN_CALL struct dirent* readdir(DIR* directory) {
  struct dirent* entry = next<struct dirent* (*)(DIR*)>("readdir")(directory);
  if (entry != nullptr && entry->d_type == DT_SOCK &&
      std::strncmp(entry->d_name, "event", 5) == 0) {
    entry->d_type = DT_CHR;
  }
  return entry;
}
STANDIN_CALL struct dirent64* readdir64(DIR* directory) {
  return reinterpret_cast<struct dirent64*>(readdir(directory));
}
