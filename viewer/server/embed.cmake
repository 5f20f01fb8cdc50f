# cmake -DOUT=FILE.cpp -DFOLDER=DIR -P embed.cmake: the files of a folder as C++, in the order of their names.
file(GLOB files ${FOLDER}/*)
list(SORT files)
set(types html text/html js text/javascript css text/css svg image/svg+xml txt text/plain json application/json
    png image/png webp image/webp ico image/x-icon woff2 font/woff2)
set(arrays)
set(rows)
set(number 0)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME)
  get_filename_component(extension ${file} LAST_EXT)
  string(SUBSTRING "${extension}" 1 -1 extension)
  list(FIND types "${extension}" at)
  if(at EQUAL -1)
    continue()  # source maps and such are not served
  endif()
  math(EXPR at "${at} + 1")
  list(GET types ${at} type)
  if(type MATCHES "^text/")
    string(APPEND type "; charset=utf-8")
  endif()
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  string(APPEND arrays "constexpr unsigned char kFile${number}[] = {${bytes}0};\n")
  string(APPEND rows "    {\"/${name}\", \"${type}\", text(kFile${number}, sizeof kFile${number} - 1)},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUT}.new "#include \"viewer/server/web_files.h\"
namespace thigma::live {
namespace {
${arrays}
std::string_view text(const unsigned char* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}
}  // namespace
std::vector<WebFile> web_files() {
  return {
${rows}  };
}
}  // namespace thigma::live
")
file(RENAME ${OUT}.new ${OUT})
