#include "viewer/server/web_files.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace thigma::live {
namespace {

TEST(WebFiles, ThePageIsPartOfTheProgram) {
  const std::vector<WebFile> files = web_files();
  const auto page = std::find_if(files.begin(), files.end(),
                                 [](const WebFile& f) { return f.path == "/index.html"; });
  ASSERT_NE(page, files.end());
  EXPECT_EQ(page->type, "text/html; charset=utf-8");
  EXPECT_NE(page->data.find("</html>"), std::string_view::npos);  // whole
  for (const WebFile& file : files) {
    EXPECT_EQ(file.path.front(), '/');
    EXPECT_FALSE(file.data.empty()) << file.path;
  }
}

}  // namespace
}  // namespace thigma::live
