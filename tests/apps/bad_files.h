#pragma once
// Files nobody wants to be given, one or more of every kind the program has to cope with.

#include <string>
#include <vector>

namespace thigma::test {

/// What the program owes to a file.
enum class Due {
  refusal,  // exit 4 from inspect and run
  repair,   // inspect 0, run 4 naming --repair, run --repair 0
  result,   // inspect 0, run 0 with a force felt
  either,   // damage that may leave a sound mesh: refusal, repair or any result
};

struct BadMesh {
  std::string kind;  // of the list in the table
  std::string name;  // of the file
  std::string bytes;
  Due due = Due::refusal;
  std::string says;  // what the message must hold, "" for anything
};

/// Mesh files, made from procedural shapes.
std::vector<BadMesh> bad_meshes();

struct BadScene {
  std::string kind, name, bytes;
  std::string says;  // what the message must hold
};

/// Scene files, all to be refused.
std::vector<BadScene> bad_scenes();

}  // namespace thigma::test
