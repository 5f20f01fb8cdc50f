#include "thigma/files/byte_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma {

FileSource::FileSource(const std::string& path, std::size_t window, std::uint64_t most)
    : path_(path), window_(window), most_(most) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat info {};
  if (file.is_open() && ::fstat(file.get(), &info) == 0 && S_ISREG(info.st_mode)) {
    file_ = std::move(file);
    size_ = static_cast<std::uint64_t>(info.st_size);
    return;
  }
  file = Descriptor();
  buffer_ = read_file(path);  // says what is wrong, or waits for a pipe
  size_ = buffer_.size();
}

void FileSource::load(std::uint64_t at, std::size_t count) {
  begin_ = at;
  buffer_.resize(count);
  for (std::size_t have = 0; have < count;) {
    const ssize_t n =
        ::pread(file_.get(), buffer_.data() + have, count - have, static_cast<off_t>(at + have));
    if (n < 0 && errno == EINTR) continue;
    if (n > 0) {
      have += static_cast<std::size_t>(n);
      continue;
    }
    buffer_.clear();
    throw InputError(path_ + ": cannot be read (" +
                     (n < 0 ? std::strerror(errno) : "it has become shorter") + "), byte " +
                     std::to_string(at + have) + ", expected " + std::to_string(size_) + " bytes");
  }
}

std::string_view FileSource::view(std::uint64_t at, std::uint64_t count) {
  const bool is_here =
      at >= begin_ && at - begin_ <= buffer_.size() && count <= buffer_.size() - (at - begin_);
  if (!is_here) {
    if (count > most_) {
      throw InputError(path_ + ": a piece of " + std::to_string(count) + " bytes, byte " +
                       std::to_string(at) + ", expected at most " + std::to_string(most_));
    }
    const std::uint64_t ahead = std::max<std::uint64_t>(count, window_);
    load(at, static_cast<std::size_t>(std::min(ahead, size_ - at)));
  }
  return std::string_view(buffer_).substr(static_cast<std::size_t>(at - begin_),
                                          static_cast<std::size_t>(count));
}

}  // namespace thigma
