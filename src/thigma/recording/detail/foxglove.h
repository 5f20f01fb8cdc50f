#pragma once
// What is seen of a session, in the JSON schemas that Foxglove's 3D panel shows: frames, surfaces,
// contacts, the force. For pictures alone; nothing here is read back.

#include <cstdint>
#include <string>
#include <string_view>

#include "thigma/loop/samples.h"
#include "thigma/recording/recording.h"

namespace thigma::detail {

inline constexpr std::string_view kTransformsSchemaName = "foxglove.FrameTransforms";
inline constexpr std::string_view kSceneSchemaName = "foxglove.SceneUpdate";

/// JSON Schemas of the two, with the fields that are written.
std::string_view transforms_schema();
std::string_view scene_schema();

/// Seen at this many pictures a second of session time [Hz].
inline constexpr double kPicturesPerSecond = 60.0;

/// An arrow as long as the object's radius stands for this force [N].
inline constexpr double kForcePerRadius = 5.0;

/// One message each, appended. `time` [ns; session clock].
void put_transforms(std::string& out, std::uint64_t time, const HapticSample& sample);
void put_surface(std::string& out, const RecordedSurface& surface);
/// The force of the contacts on the object, an arrow at its centre of mass; radius [m].
void put_force(std::string& out, std::uint64_t time, const HapticSample& sample, double radius);
/// Points of the scene that the contact model has, a ball each.
void put_contacts(std::string& out, std::uint64_t time, const ContactSample& sample, double radius);

}  // namespace thigma::detail
