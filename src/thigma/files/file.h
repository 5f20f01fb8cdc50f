#pragma once
// Whole files in and out. Output appears complete or not at all.

#include <string>
#include <string_view>

#include "thigma/files/descriptor.h"

namespace thigma {

/// All bytes of a file, a regular one or a pipe, of at most 4 GiB. A pipe that nobody has opened
/// for writing within two seconds is none that will be.
///
/// Thread    [offline]; throws InputError when it cannot be opened or read: what a user names as
///           input is input.
std::string read_file(const std::string& path);

/// Replaces or creates `path` with `bytes`: written beside it under a name of its own, on the disk,
/// then renamed, so that a reader, another writer, a full disk, a crash or a power cut never sees
/// half of it. A device such as /dev/stdout is written directly.
///
/// Thread    [offline]; throws IoError, and nothing has changed.
void write_file(const std::string& path, std::string_view bytes);

/// write_file for what is written a piece at a time.
/// Thread: one, [offline]; members throw IoError, and then nothing is left.
class FileWriter {
 public:
  explicit FileWriter(const std::string& path);
  ~FileWriter();  // without keep(): nothing has changed
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;
  void append(std::string_view bytes);
  void keep();

 private:
  [[noreturn]] void fail();

  std::string path_, temporary_;  // "" for a device, which is written directly
  Descriptor file_;
};

/// A text without the UTF-8 byte order mark that editors may put before it. Every reader of text
/// skips it.
///
/// Thread    [any]
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text) noexcept;

}  // namespace thigma
