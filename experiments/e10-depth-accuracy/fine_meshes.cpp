#include "experiments/e10-depth-accuracy/fine_meshes.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/probe.h"
#include "experiments/common/fine_depth.h"
#include "experiments/common/statistics.h"
#include "experiments/common/textured_session.h"

#include "thigma/loop/contact_step.h"
#include "thigma/math/quantile.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/models/textured_parts.h"
#include "thigma/response/texture_contacts.h"

namespace thigma::experiments::e10_depth_accuracy {
namespace {

/// A scene with two models of Table 4.1.
struct Pair {
  const char* name;
  const char* scene;  // built in
  const char* object;
  const char* fixed;
  const char* object_here;  // takes the place of the scene's object; null: none does
  Vec3 start;               // of that, by its mesh [m]
  Quat turn;
};

// The gear stands on the flange beside its boss, its axis level, and rolls.
const Pair kPairs[] = {
    {"hammer_on_torus", "hammer_on_torus", "hammer", "helicoidal_torus", nullptr, Vec3::Zero(),
     Quat::Identity()},
    {"file_on_cad", "file_on_cad", "file", "cad_part", nullptr, Vec3::Zero(), Quat::Identity()},
    {"gear_on_cad", "file_on_cad", "gear", "cad_part", "procedural:gear", Vec3(0.036, 0.0, 0.069),
     Quat(0.7071067811865476, 0.0, 0.7071067811865476, 0.0)}};

std::unique_ptr<TexturedSession> open(const Pair& pair) {
  return textured_session(pair.scene, true, [&](SceneDescription& scene) {
    if (pair.object_here == nullptr) return;
    scene.object.name = pair.object;
    scene.object.mesh = pair.object_here;
    scene.object.textured_model = models::TexturedRequest{pair.object, 0};
    scene.object.world_from_mesh = {pair.start, pair.turn};
  });
}

/// Contact steps of a session at poses that a hand might reach.
class Presser {
 public:
  explicit Presser(TexturedSession& session) : session_(session) {
    reserve_contact_scratch(session.config.contact, scratch);
  }

  /// Lowers the object, moved and turned at random, until its deepest contact is that deep; false
  /// where it never is.
  bool press(Random& random, double depth) {
    Pose pose = session_.config.world_from_body;
    const double across = random.uniform(-0.006, 0.006), along = random.uniform(-0.006, 0.03);
    // From above whatever lies there.
    constexpr double kAbove = 0.02, kFarthest = 0.034;  // [m]
    pose.position += Vec3(across, along, kAbove);
    const Vec3 lean(random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06),
                    random.uniform(-0.5, 0.5));
    pose.orientation = rotation_from_vector(lean) * pose.orientation;
    double high = 0.0, low = kFarthest;
    for (int k = 0; k < 16; ++k) {
      const double middle = 0.5 * (high + low);
      (step(pose, middle) < depth ? high : low) = middle;
    }
    return std::fabs(step(pose, low) - depth) < 1e-5;
  }

  ContactScratch scratch;
  std::vector<double> seconds;  // of every contact step that had depths

 private:
  double step(Pose pose, double lower) {
    BodyState state;
    state.position = pose.position - Vec3(0.0, 0.0, lower);
    state.orientation = pose.orientation;
    const double start = bench::thread_cpu();
    contact_step(session_.config.contact, {state, 1e-3 * static_cast<double>(count_), count_ + 1},
                 scratch, sample_);
    ++count_;
    double deepest = kNoDepth;
    for (const DepthTerm& term : sample_.model.depths) deepest = std::max(deepest, term.depth);
    if (deepest > 0.0) seconds.push_back(bench::thread_cpu() - start);
    return deepest;
  }

  TexturedSession& session_;
  ContactSample sample_;
  std::uint64_t count_ = 0;
};

/// What depths are off by [m].
struct FineErrors {
  // of every contact, of those that no end of a patch holds, of frames' deepest
  std::vector<double> contacts, inner, frames;
  int not_height_field = 0;  // of the contacts
  int of_sheets = 0;         // of these, by their sheets
};

// Contacts farther apart than this are none of a hand's: they have no force.
constexpr double kApart = 5e-4;  // [m]
// Of the fine surface off the coarse one along n: sheets that far off are others.
constexpr double kBand = 2e-3;  // [m]

void compare(const Pair& pair, const ContactScratch& scratch, const TriangleMesh& object,
             const TriangleMesh& fixed, int frame, FineErrors& errors, Table& table) {
  double deepest = kNoDepth, want_deepest = kNoDepth;
  for (std::size_t i = 0; i < scratch.textures->contacts.size(); ++i) {
    const DepthContact& contact = scratch.textures->contacts[i];
    const DepthSamples& sample = scratch.textures->samples[i];
    if (!sample.is_found || sample.depth[0] < -kApart) continue;
    const auto side = [](const TexturedPatch& patch, const TriangleMesh& fine) {
      return FineSide{&fine, &patch.texture->coarse, patch.triangles, patch.world_from_body};
    };
    const FineDepth want = fine_depth(side(contact.object, object), side(contact.scene, fixed),
                                      sample.frame.world_from_contact, sample.frame.origin, kBand);
    if (!want.is_found) continue;
    errors.contacts.push_back(std::fabs(sample.depth[0] - want.depth));
    if (!want.is_at_rim) errors.inner.push_back(errors.contacts.back());
    errors.not_height_field += !sample.is_height_field;
    errors.of_sheets += sample.is_of_sheets;
    deepest = std::max(deepest, sample.depth[0]);
    want_deepest = std::max(want_deepest, want.depth);
    add_row(table, {std::string(pair.name), static_cast<double>(frame), static_cast<double>(i),
                    sample.depth[0], want.depth, want.is_at_rim ? 1.0 : 0.0,
                    sample.is_height_field ? 1.0 : 0.0, sample.is_of_sheets ? 1.0 : 0.0});
  }
  if (deepest > kNoDepth) errors.frames.push_back(std::fabs(deepest - want_deepest));
}

void add_claims(const Pair& pair, const FineErrors& errors, std::vector<double> seconds,
                Outcome& outcome) {
  const std::string of = std::string("-") + pair.name, here = std::string(pair.name) + ": ";
  const auto claim = [&](Claim c) { outcome.claims.push_back(std::move(c)); };
  const auto at = [](const std::vector<double>& of_all, double share) {
    return 1e6 * sample_quantile(of_all, share);
  };
  claim(at_most("fine-median" + of,
                here + "depth of a contact against the fine meshes, median error",
                at(errors.contacts, 0.5), 10.0, "um"));
  claim(at_most("fine-p90" + of, here + "the same, 90 % quantile", at(errors.contacts, 0.9), 30.0,
                "um"));
  claim(at_most("fine-max" + of, here + "the same, largest of those that no end of a patch holds",
                at(errors.inner, 1.0), 60.0, "um"));
  claim(at_most("fine-max-all" + of, here + "the same, largest of all", at(errors.contacts, 1.0),
                60.0, "um"));
  claim(at_most("fine-frame-median" + of, here + "deepest depth of a frame, median error",
                at(errors.frames, 0.5), 10.0, "um"));
  claim(at_most("fine-frame-p90" + of, here + "the same, 90 % quantile", at(errors.frames, 0.9),
                30.0, "um"));
  claim(at_most("fine-frame-max" + of, here + "the same, largest", at(errors.frames, 1.0), 60.0,
                "um"));
  outcome.claims.push_back(stated("fine-contacts" + of, here + "contacts compared",
                                  static_cast<double>(errors.contacts.size())));
  outcome.claims.push_back(
      stated("fine-rim" + of, here + "of these, the end of a patch holds the deepest place",
             static_cast<double>(errors.contacts.size() - errors.inner.size())));
  outcome.claims.push_back(stated("fine-not-height-field" + of,
                                  here + "of these, no height field there",
                                  errors.not_height_field));
  outcome.claims.push_back(stated("fine-sheets" + of,
                                  here + "of these, depths of all sheets about the place",
                                  errors.of_sheets));
  outcome.claims.push_back(stated("fine-frames" + of, here + "frames that were pressed",
                                  static_cast<double>(errors.frames.size())));
  outcome.claims.push_back(stated("fine-time" + of, here + "CPU time of a contact step, median",
                                  1e6 * sample_quantile(seconds, 0.5), "us"));
  outcome.claims.push_back(stated("fine-time-p99" + of, here + "the same, 99 % quantile",
                                  1e6 * sample_quantile(seconds, 0.99), "us"));
}

}  // namespace

void against_fine_meshes(const Context& context, Outcome& outcome) {
  Table table{.name = "fine",
              .columns = {"scene", "frame", "contact", "depth [m]", "fine meshes [m]", "at the rim",
                          "height field", "of sheets"}};
  const int frames = context.quick ? 8 : 100;
  for (const Pair& pair : kPairs) {
    tell(context, pair.name);
    const std::unique_ptr<TexturedSession> session = open(pair);
    const TriangleMesh object = models::make_fine_sheets(models::textured_part(pair.object)),
                       fixed = models::make_fine_sheets(models::textured_part(pair.fixed));
    Presser presser(*session);
    Random random(context.seed + 11);
    FineErrors errors;
    for (int i = 0; i < frames; ++i)
      if (presser.press(random, random.uniform(0.0, 3e-4)))
        compare(pair, presser.scratch, object, fixed, i, errors, table);
    add_claims(pair, errors, presser.seconds, outcome);
  }
  outcome.tables.push_back(std::move(table));
}

}  // namespace thigma::experiments::e10_depth_accuracy
