#include "thigma/core/error.h"
#include "thigma/files/checksum.h"
#include "thigma/recording/detail/mcap_records.h"
#include "thigma/recording/mcap_file.h"

namespace thigma {
namespace {

using namespace detail;

constexpr std::uint64_t kRecordHead = 9;        // opcode and length
constexpr std::size_t kMostAttachments = 1000;  // of a file

/// The content of an attachment record, a field after the other.
struct Fields {
  std::string_view left;
  const std::string& path;
  std::uint64_t at;  // of the record, for messages

  [[noreturn]] void fail(const char* what, const char* expected) const {
    throw InputError(path + ": " + what + ", byte " + std::to_string(at) + ", expected " +
                     expected);
  }
  std::string_view take(std::uint64_t count) {
    if (count > left.size()) fail("an attachment that says it is longer than it is", "its length");
    const std::string_view taken = left.substr(0, static_cast<std::size_t>(count));
    left.remove_prefix(static_cast<std::size_t>(count));
    return taken;
  }
  std::uint64_t number(std::size_t bytes) {
    std::uint64_t value = 0;
    const std::string_view taken = take(bytes);
    for (std::size_t i = 0; i < bytes; ++i)
      value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(taken[i])) << (8 * i);
    return value;
  }
};

McapAttachment read_attachment(std::string_view content, const std::string& path,
                               std::uint64_t at) {
  Fields fields{content, path, at};
  fields.take(16);  // times
  McapAttachment attachment;
  attachment.name = fields.take(fields.number(4));
  attachment.media_type = fields.take(fields.number(4));
  attachment.data = fields.take(fields.number(8));
  const std::string_view covered = content.substr(0, content.size() - fields.left.size());
  const std::uint64_t crc = fields.number(4);
  if (!fields.left.empty()) fields.fail("bytes behind an attachment", "none");
  if (crc != 0 && crc != crc32(covered))
    fields.fail("an attachment is not what its checksum says", "the file as it was written");
  return attachment;
}

}  // namespace

std::vector<McapAttachment> read_attachments(ByteSource& source, const std::string& path) {
  const std::uint64_t size = source.size(), magic = kMcapMagic.size();
  if (size < magic || source.view(0, magic) != kMcapMagic)
    throw InputError(path + ": not an MCAP file, byte 0, expected its magic bytes");
  std::vector<McapAttachment> found;
  for (std::uint64_t at = magic; size - at >= kRecordHead;) {
    const std::string_view head = source.view(at, kRecordHead);
    const auto opcode = static_cast<std::uint8_t>(head[0]);
    const std::uint64_t length = Fields{head.substr(1), path, at}.number(8);
    const std::uint64_t begin = at + kRecordHead;
    if (opcode == kNoRecord || opcode == kDataEnd || opcode == kFooter) break;
    if (length > size - begin) break;  // cut off there
    if (opcode == kAttachment) {
      if (found.size() == kMostAttachments)
        throw InputError(path + ": more attachments, byte " + std::to_string(at) +
                         ", expected at most 1000");
      found.push_back(read_attachment(source.view(begin, length), path, at));
    }
    at = begin + length;
  }
  return found;
}

}  // namespace thigma
