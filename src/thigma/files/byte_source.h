#pragma once
// Bytes that need not fit in memory, looked at a stretch at a time.

#include <cstdint>
#include <string>
#include <string_view>

#include "thigma/files/descriptor.h"

namespace thigma {

/// Bytes by their place.
/// Thread: one, [offline].
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;  // [byte]
  /// `count` bytes from `at`, which are within size(). Valid until the next call.
  /// errors  InputError where they cannot be read, or are more than are kept in memory
  virtual std::string_view view(std::uint64_t at, std::uint64_t count) = 0;
};

/// Bytes in memory, which outlive this.
class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::string_view bytes) : bytes_(bytes) {}
  std::uint64_t size() const override { return bytes_.size(); }
  std::string_view view(std::uint64_t at, std::uint64_t count) override {
    return bytes_.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(count));
  }

 private:
  std::string_view bytes_;
};

/// A regular file of any size, as long as it was when it was opened. A pipe is read to its end
/// first.
class FileSource final : public ByteSource {
 public:
  /// window  read at once [byte]; most: the longest stretch that is asked for [byte]
  /// errors  InputError as read_file
  explicit FileSource(const std::string& path, std::size_t window = std::size_t{1} << 22,
                      std::uint64_t most = std::uint64_t{1} << 28);
  std::uint64_t size() const override { return size_; }
  std::string_view view(std::uint64_t at, std::uint64_t count) override;
  std::size_t memory() const { return buffer_.capacity(); }  // [byte]

 private:
  void load(std::uint64_t at, std::size_t count);

  std::string path_;
  Descriptor file_;  // not open for a pipe
  std::uint64_t size_ = 0, begin_ = 0;
  std::size_t window_;
  std::uint64_t most_;
  std::string buffer_;  // what lies from begin_ on
};

}  // namespace thigma
