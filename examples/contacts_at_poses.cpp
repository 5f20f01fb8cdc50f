// Contacts of two meshes at given poses, without a session: exact, one line a pose.
#include <cstdio>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/mesh/shapes.h"

using namespace thigma;

int main() {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(0.02, 12));
  const ClodHierarchy plate = build_exact_hierarchy(make_box({0.2, 0.2, 0.01}));
  ContactFront front;  // remembers the last pose; results do not depend on it
  ContactSet found;
  for (int i = 0; i <= 4; ++i) {
    const Pose pose{{0.0, 0.0, 0.027 - 0.001 * i}};
    clear(found);
    query_contacts({ball, pose}, {plate}, {.tolerance = 0.002}, front, found);
    double deepest = -0.002;
    for (const Contact& contact : found.contacts) deepest = std::max(deepest, contact.depth);
    std::printf("z %.3f m: %zu contacts, deepest %+.3f mm\n", pose.position.z(),
                found.contacts.size(), 1e3 * deepest);
  }
}
