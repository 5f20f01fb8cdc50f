#include "thigma/import/detail/foreign_formats.h"

namespace thigma::detail {
namespace {

constexpr const char* kFromCad = "triangles: export STL or OBJ from the program that made it";
constexpr const char* kConverted = "a mesh alone: convert it to OBJ, PLY or STL";

constexpr ForeignFormat kStep{"a STEP file", kFromCad};
constexpr ForeignFormat kIges{"an IGES file", kFromCad};
constexpr ForeignFormat kGltf{"a glTF file", kConverted};
constexpr ForeignFormat kFbx{"an FBX file", kConverted};
constexpr ForeignFormat kZip{"an archive, as 3MF files are", kConverted};
constexpr ForeignFormat kXml{"an XML file, as COLLADA files are", kConverted};
constexpr ForeignFormat kMcap{"a recording or a packed scene",
                              "a mesh; `thigma run` opens scenes, `thigma replay` recordings"};

// A line of an IGES file has 80 columns: the 73rd is its section, S of the first, and then the
// number of the line in it.
constexpr std::size_t kIgesLine = 80, kIgesSection = 72;

bool is_iges(std::string_view bytes) {
  const std::string_view line = bytes.substr(0, bytes.find_first_of("\r\n"));
  if (line.size() != kIgesLine || line[kIgesSection] != 'S') return false;
  const std::string_view number = line.substr(kIgesSection + 1);
  const std::size_t one = number.find_first_not_of(" 0");
  return one == number.size() - 1 && number[one] == '1';
}

/// JSON that begins as glTF does.
bool is_gltf_text(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || bytes[first] != '{') return false;
  const std::string_view begin = bytes.substr(0, 1 << 16);
  return begin.find("\"asset\"") != std::string_view::npos ||
         begin.find("\"meshes\"") != std::string_view::npos ||
         begin.find("\"buffers\"") != std::string_view::npos;
}

}  // namespace

const ForeignFormat* foreign_format(std::string_view bytes) noexcept {
  if (bytes.starts_with("ISO-10303-21")) return &kStep;
  if (bytes.starts_with("glTF") || is_gltf_text(bytes)) return &kGltf;
  if (bytes.starts_with("Kaydara FBX")) return &kFbx;
  if (bytes.starts_with("PK\x03\x04")) return &kZip;
  if (bytes.starts_with("<?xml")) return &kXml;
  if (bytes.starts_with("\x89MCAP0\r\n")) return &kMcap;
  return is_iges(bytes) ? &kIges : nullptr;
}

}  // namespace thigma::detail
