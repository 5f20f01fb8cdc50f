#pragma once
// Pictures for tests, as libpng writes them.

#include <string>
#include <vector>

#include <png.h>

namespace thigma::test {

/// A grey PNG of rows as libpng takes them.
inline std::string png_of(int width, int height, int bits, const std::vector<unsigned char>& data,
                          int color = PNG_COLOR_TYPE_GRAY, int interlace = PNG_INTERLACE_NONE) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &out,
      [](png_structp p, png_bytep bytes, png_size_t count) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(bytes), count);
      },
      nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
               color, interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  const std::size_t row = data.size() / static_cast<std::size_t>(height);
  std::vector<png_bytep> rows;
  for (int i = 0; i < height; ++i)
    rows.push_back(const_cast<png_bytep>(data.data()) + static_cast<std::size_t>(i) * row);
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return out;
}

}  // namespace thigma::test
