#pragma once
// How fine a contact query is asked to be, contact by contact (Sec. 3.4.3).

#include <cstddef>
#include <cstdint>
#include <limits>

#include "thigma/math/types.h"

namespace thigma {

inline constexpr double kNoCap = std::numeric_limits<double>::infinity();

/// How the support area D of a contact is read (Sec. 3.3.5). The text has it of the vertices around
/// the contact, in two readings: of the faces at a vertex alone, or of all faces connected to it
/// that pass the same test. `patch` has one D for all contacts of a patch, the harmonic mean of the
/// second over its area: with the haptic metric alone the level is then a property of the pair, it
/// never changes while a contact lasts, and nothing is blended (docs/deviations.md, D106).
enum class SupportReading : std::uint8_t { one_ring = 0, flood = 1, patch = 2 };
inline constexpr std::size_t kSupportReadings = 3;

/// Which of the two D of a contact counts; the text takes the larger (Eq. 3.7).
enum class SupportArea : std::uint8_t { larger, smaller };

/// Surface deviation that is not seen: some pixels on screen, at the distance of the contact (Eq.
/// 3.8).
struct ViewThreshold {
  double pixels = 1.0;         // N
  double distance = 0.0;       // l, from the eye [m]
  double frustum_size = 0.0;   // f, of the near plane [m]
  double near_distance = 0.0;  // n [m]
  double image_size = 0.0;     // i [pixels]
};

/// What s0 is compared with. Several may be on: the least of their thresholds counts.
struct RefinementMetric {
  // s0, times the smaller radius of the two; 0 with the others off: finest patches
  double haptic = 0.0;
  // alpha: s0 = alpha * relative speed of the bodies at the contact; 0: off [s]
  double velocity = 0.0;
  ViewThreshold view{.pixels = 0.0};  // s0 of Eq. 3.8; pixels 0: off
  bool has_eye = false;     // view.distance is measured from `eye` to each contact; off: as given
  Vec3 eye = Vec3::Zero();  // [m; world]
};

/// Resolution of a query. The default is exact: finest patches everywhere.
///
/// A pair of patches is refined while s* > s0, the surface deviations of the two exceed the cap
/// together, or one is of a level beyond the coarsest.
struct Resolution {
  bool is_exact = true;  // everything below is ignored
  RefinementMetric metric{.haptic = 0.025};
  // on s_a + s_b, times the smaller radius; infinite: off, as in the text
  double deviation_cap = kNoCap;
  // pairs with a coarser patch are refined
  std::int32_t coarsest_level = std::numeric_limits<std::int32_t>::max();
  SupportReading reading = SupportReading::flood;
  SupportArea area = SupportArea::larger;
  // contacts of a pair near its threshold are blended with its children's (Sec. 3.4.4), where
  // s* / s0 depends on the pose
  bool interpolates = true;
  double step_time = 0.001;       // from the query before, for speeds [s]
  std::int64_t budget_tests = 0;  // pairs looked at, at most; 0: no limit. Reproducible
  double budget_cpu = 0.0;        // CPU time of the thread, at most; 0: no limit [s]
  // Contacts are carried along with the bodies until these may have moved by this share of d since
  // they were measured, and `bound` grows by what they moved; 0: all are measured each frame. What
  // may touch, turn or change its level is measured all the same; with a budget, other metrics or
  // exact_within nothing is carried. The answer then depends on the queries before, an exact one's
  // too.
  double carry = 0.0;
  // Finest near, coarse far: a pair stays coarse where all below it is proven apart by more than
  // `exact_within` along its normal, in whatever way the object turns by `turn`, and s* can be
  // within s0 of the haptic metric and its deviations within the cap. All others are refined.
  // Nothing is blended, no other metric and no budget counts. 0: off [m, rad]
  double exact_within = 0.0, turn = 0.0;
};

}  // namespace thigma
