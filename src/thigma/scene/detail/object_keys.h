#pragma once
// Tables that scenes of one moving object and worlds of several have in common.

#include <optional>
#include <string>

#include "thigma/scene/detail/toml_table.h"
#include "thigma/scene/scene_description.h"

namespace thigma::detail {

/// The keys every object has; mesh and unit_scale are looked into by resolve_object.
struct ObjectKeys {
  std::optional<std::string> mesh, texture, name;
  std::optional<double> unit_scale;
  Pose pose;
  std::optional<Material> material;
};

/// Thread [offline]; throws InputError.
ObjectKeys read_object_keys(TomlTable& table);

/// Finds its mesh.
///
/// folder  what relative paths are relative to
/// Thread  [offline]; throws InputError
SceneObject resolve_object(const TomlTable& table, const ObjectKeys& keys,
                           const std::string& folder);

/// The numbers of a table [safety], those that it does not name as they are. Thread [offline];
/// throws InputError.
void read_safety_limits(TomlTable& table, SafetyLimits& safety);

/// The whole table [coupling]. Thread [offline]; throws InputError.
void read_coupling(TomlTable table, CouplingGains& coupling);

}  // namespace thigma::detail
