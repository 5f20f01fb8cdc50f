// libpng reports errors by a jump: functions that can be left that way own nothing.
#include "height_file.h"

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <vector>

#include <png.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::app {
namespace {

struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  const char* at = nullptr;
  const char* end = nullptr;
  char why[128] = "is no PNG";
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void keep_error(png_structp png, png_const_charp why) {
  auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
  std::strncpy(reader->why, why, sizeof reader->why - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep out, png_size_t count) {
  auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
  if (static_cast<std::size_t>(reader->end - reader->at) < count) png_error(png, "is cut off");
  std::memcpy(out, reader->at, count);
  reader->at += count;
}

/// Reads what stands before the picture. False: see `why`.
bool read_header(PngReader& reader) {
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, keep_error, ignore_warning);
  if (!reader.png) return false;
  reader.info = png_create_info_struct(reader.png);
  if (!reader.info || setjmp(png_jmpbuf(reader.png))) return false;
  png_set_read_fn(reader.png, &reader, read_bytes);
  png_set_user_limits(reader.png, kMaxTextureSide, kMaxTextureSide);
  png_set_chunk_malloc_max(reader.png, 1 << 20);
  png_read_info(reader.png, reader.info);
  return true;
}

/// Sets what rows look like: grey alone, 8 or 16 bits. False: see `why`.
bool choose_rows(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  if (png_get_bit_depth(reader.png, reader.info) < 8) png_set_expand_gray_1_2_4_to_8(reader.png);
  png_set_strip_alpha(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

bool read_rows(PngReader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

[[noreturn]] void fail(const std::string& name, const std::string& what, std::size_t byte,
                       const std::string& expected) {
  throw InputError(name + ": " + what + ", byte " + std::to_string(byte) + ", expected " +
                   expected);
}

/// Refuses a piece that claims more bytes than there are: the library would set aside as many.
void check_pieces(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kMagic = 8, kAround = 12;  // length, kind and checksum of a piece
  for (std::size_t at = kMagic; at < bytes.size();) {
    if (bytes.size() - at < kAround)
      fail(name, "PNG: is cut off in a piece", at, "an undamaged grey PNG");
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
      length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
    if (length > bytes.size() - at - kAround)
      fail(name, "PNG: a piece of " + std::to_string(length) + " bytes", at,
           "no more than there are: an undamaged grey PNG");
    if (bytes.substr(at + 4, 4) == "IEND") return;
    at += kAround + length;
  }
}

HeightImage parse_png(std::string_view bytes, const std::string& name) {
  check_pieces(bytes, name);
  PngReader reader;
  reader.at = bytes.data();
  reader.end = bytes.data() + bytes.size();
  const auto refuse = [&] {
    fail(name, std::string("PNG: ") + reader.why,
         static_cast<std::size_t>(reader.at - bytes.data()), "an undamaged grey PNG");
  };
  if (!read_header(reader)) refuse();
  const int color = png_get_color_type(reader.png, reader.info);
  if (color != PNG_COLOR_TYPE_GRAY && color != PNG_COLOR_TYPE_GRAY_ALPHA)
    fail(name, "is a picture in colour", 25, "heights: a grey one");
  HeightImage image;
  image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  const std::size_t width = static_cast<std::size_t>(image.width),
                    height = static_cast<std::size_t>(image.height);
  // Deflate shrinks to a thousandth at best: what claims more than that is not there.
  constexpr std::size_t kMostShrunk = 1100;
  const std::size_t pixel_bits = std::size_t{png_get_bit_depth(reader.png, reader.info)} *
                                 png_get_channels(reader.png, reader.info);
  if (width * height > static_cast<std::size_t>(kMaxTexels) ||
      width * height * pixel_bits / 8 > kMostShrunk * bytes.size())
    fail(name, "claims " + std::to_string(width * height) + " greys", 16,
         "no more than there can be");
  if (!choose_rows(reader)) refuse();
  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  std::vector<unsigned char> data(row_bytes * height);
  std::vector<png_bytep> rows(height);
  for (std::size_t i = 0; i < height; ++i) rows[i] = data.data() + i * row_bytes;
  if (!read_rows(reader, rows.data())) refuse();
  const bool is_deep = png_get_bit_depth(reader.png, reader.info) == 16;
  image.values.reserve(width * height);
  for (const unsigned char* row : rows) {
    for (std::size_t i = 0; i < width; ++i)
      image.values.push_back(is_deep
                                 ? static_cast<float>(256 * row[2 * i] + row[2 * i + 1]) / 65535.0f
                                 : static_cast<float>(row[i]) / 255.0f);
  }
  return image;
}

}  // namespace

HeightImage parse_height_file(std::string_view bytes, const std::string& name) {
  const std::string_view text = without_byte_order_mark(bytes);
  if (is_pgm(text)) return parse_pgm(text, name);
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return parse_png(bytes, name);
  fail(name, "is no height map", 0, "a PGM or a grey PNG");
}

HeightImage read_height_file(const std::string& path) {
  return parse_height_file(read_file(path), path);
}

}  // namespace thigma::app
