#pragma once
// The page, as it was when the program was built.

#include <vector>

#include "viewer/server/web_server.h"

namespace thigma::live {

/// Every file of viewer/web/dist; or a single page that says that there was none.
std::vector<WebFile> web_files();

}  // namespace thigma::live
