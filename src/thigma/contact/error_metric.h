#pragma once
// How much detail a contact deserves: error of a pair of levels, weighted by the size of the
// contact (Sec. 3.3-3.4).

namespace thigma {

/// What a level of detail is at a contact.
struct LevelError {
  double deviation = 0.0;     // s: surface deviation from the original, both ways [m]
  double resolution = 0.0;    // r [1/m]; not read of free levels
  double support_area = 0.0;  // D at the contact [m^2]
  bool is_free = false;       // a level of merged hulls alone has no resolution
};

enum class SupportArea {
  larger,
  smaller
};  // which of the two D counts; the text takes the larger (Eq. 3.7)

/// s*: feature size s / r^2, the larger of the two, over the support area. Infinite for a free
/// level and for an area of 0, unless the feature size is 0 too.
/// Thread    [contact].
/// Source    Eqs. 3.6-3.7.
double weighted_deviation(const LevelError& object, const LevelError& scene,
                          SupportArea area = SupportArea::larger) noexcept;

/// Surface deviation that is not seen: some pixels on screen, at the distance of the contact (Eq.
/// 3.8).
struct ViewThreshold {
  double pixels = 1.0;         // N
  double distance = 0.0;       // l, from the eye [m]
  double frustum_size = 0.0;   // f, of the near plane [m]
  double near_distance = 0.0;  // n [m]
  double image_size = 0.0;     // i [pixels]
};
double view_threshold(const ViewThreshold& view) noexcept;  // [m]

}  // namespace thigma
