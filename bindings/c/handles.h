#pragma once
// What the handles of the C door hold.

#include <memory>

#include "scene_run.h"

#include "thigma/clod/clod_asset.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/thigma_c.h"

struct thigma_mesh {
  thigma::TriangleMesh surface;
};

struct thigma_clod {
  std::shared_ptr<const thigma::ClodAsset> asset;
};

struct thigma_tracker {
  std::shared_ptr<const thigma::ClodAsset> object, scene;
  thigma::Pose scene_pose;
  thigma::ContactQuery query;
  thigma::ContactFront front;
  thigma::ContactSet found;
};

struct thigma_scene {
  std::shared_ptr<const thigma::Scene> scene;
};

/// One of the two.
struct thigma_session {
  std::unique_ptr<thigma::bindings::SteppedRun> stepped;
  std::unique_ptr<thigma::bindings::ThreadedRun> threaded;
  bool is_finished = false;
};
