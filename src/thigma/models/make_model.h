#pragma once
// Procedural models, seeded, at any triangle count.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/models/model_request.h"

namespace thigma::models {

/// A model that can be made.
struct ModelInfo {
  const char* name;
  int triangles;        // default count
  int least_triangles;  // below this the shape is no longer recognisable: refused
  const char* text;     // one line for listings
};

/// Every model, in the order of listings.
const std::vector<ModelInfo>& models();

/// Makes a model: closed, oriented, without self-intersections, in metres.
///
/// The count is met within 1 % from 2,000 triangles upwards (the nearest the construction allows
/// below). Same request, same bytes, on every machine.
/// Thread    [offline]; InputError for an unknown name or a count out of range.
TriangleMesh make_model(const ModelRequest& request);

/// True for text that starts like "procedural:".
bool is_model_uri(std::string_view text);

/// "procedural:NAME" or "procedural:NAME?triangles=N&seed=S", keys at most once each.
///
/// where   prefix of the message, "FILE" or "--object"
/// Thread  [offline]; InputError names what is wrong and the nearest right name or key.
ModelRequest parse_model_uri(std::string_view uri, const std::string& where);

/// The word of `known` nearest to `word` in edit distance, or "" when none is near.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace thigma::models
