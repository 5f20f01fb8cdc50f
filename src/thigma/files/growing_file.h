#pragma once
// A file that grows for hours and outlives what writes it.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "thigma/files/descriptor.h"

namespace thigma {

/// Longest time between two moments at which all that was appended is made safe against a power cut
/// [s].
inline constexpr int kSyncSeconds = 2;

/// A file written beside its place as PATH.part, which takes the place when it is whole.
///
/// What append() has taken survives the process; a power cut takes the last kSyncSeconds at most.
/// PATH.part is locked by the kernel, so that a second writer is refused while the first lives, and
/// none after it was killed; what a killed one left is moved out of the way, to the first free
/// PATH.part.N. Names are looked up in the folder that was opened, wherever it is moved meanwhile.
/// Thread: one thread, [offline]; another waits for the disk. Members throw IoError, one line that
/// begins with PATH.
class GrowingFile {
 public:
  /// errors   IoError where PATH is no regular file, cannot be made, or is being written by
  ///          somebody else
  explicit GrowingFile(const std::string& path);
  ~GrowingFile();  // neither kept nor discarded: PATH.part stays as it is, as after a kill
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Appends all of it or, with an error, nothing: what was there before stays as it is.
  /// room   that is set aside behind it where the file system can, so that so much is taken even by
  ///        a full disk [byte]
  void append(std::string_view bytes, std::uint64_t room = 0);

  std::uint64_t size() const { return size_.load(std::memory_order_relaxed); }  // [byte]

  /// Waits for the disk and gives the file its place. With an error it is still under part().
  void keep();

  void discard() noexcept;  // removes it

  const std::string& path() const { return path_; }
  std::string part() const { return path_ + ".part"; }
  /// Where something that a killed process left has been moved, "" where there was nothing.
  const std::string& moved() const { return moved_; }

 private:
  [[noreturn]] void fail(const std::string& why) const;
  void open_part();
  bool is_named() const;
  void move_away();
  void sync_now_and_then();
  void stop_syncing() noexcept;

  std::string path_, name_, moved_;
  Descriptor folder_, file_;
  std::atomic<std::uint64_t> size_{0};
  std::atomic<int> sync_error_{0};  // errno

  std::mutex mutex_;
  std::condition_variable wake_;
  bool is_done_ = false;
  std::thread syncing_;
};

/// Whether somebody is writing this PATH.part now, as far as this process may know. Takes no lock,
/// so that no writer is refused because of it.
/// Thread [offline]; no failure.
bool is_growing(const std::string& part);

}  // namespace thigma
