#include "verbs.h"

namespace thigma::app {

void add_all_verbs(CLI::App& app, Common& common) {
  // One line a verb; its file is listed in CMakeLists.txt.
  (void)app;
  (void)common;
}

}  // namespace thigma::app
