#pragma once
// The front door: a scene, its session, what it felt. What lies deeper is named in
// docs/architecture.md.

#include "thigma/core/error.h"            // InputError, IoError
#include "thigma/device/haptic_device.h"  // HapticDevice, DeviceLimits, DeviceState
#include "thigma/device/open_device.h"    // open_device, device_schemes
#include "thigma/loop/samples.h"          // HapticSample, ContactSample
#include "thigma/math/pose.h"             // Pose, Vec3, Quat
#include "thigma/mesh/triangle_mesh.h"    // TriangleMesh
#include "thigma/recording/recording.h"   // read_recording, export_csv
#include "thigma/scene/load_scene.h"      // Scene, load_scene, SceneSession, open_session
#include "thigma/scene/scene_file.h"      // read_scene, scene_from_pair
#include "thigma/session/session.h"       // Session, run_lockstep, SessionSummary
