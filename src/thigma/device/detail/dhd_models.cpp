// The system types of Force Dimension's library.

#include <iterator>

#include "thigma/device/detail/dhd_device.h"

namespace thigma::detail {
namespace {

// Of the types, max_force, max_torque, stiffness and angular stiffness are the per-model values
// that CHAI3D 3.3 publishes where it has them; else low guesses.
constexpr DhdModel kModels[] = {{33, "omega.3"},
                                {34, "omega.6", 4.0, 0.0, 1000.0, 0.0, 0.08, true},
                                {36, "omega.6 left", 4.0, 0.0, 1000.0, 0.0, 0.08, true},
                                {35, "omega.7", 4.0, 0.0, 1000.0, 0.0, 0.08, true},
                                {37, "omega.7 left", 4.0, 0.0, 1000.0, 0.0, 0.08, true},
                                {60, "Falcon", 8.0, 0.0, 3000.0, 0.0, 0.05},
                                {63, "delta.3", 4.0, 0.0, 1000.0, 0.0, 0.18},
                                {64, "delta.6", 4.0, 0.1, 1000.0, 0.3, 0.18, true, true},
                                {104, "sigma.7", 12.0, 0.2, 4000.0, 1.0, 0.095, true, true},
                                {105, "sigma.7 left", 12.0, 0.2, 4000.0, 1.0, 0.095, true, true},
                                {206, "sigma.3", 4.0, 0.0, 1000.0, 0.0, 0.095},
                                {108, "lambda.7", 4.0, 0.1, 8000.0, 0.3, 0.12, true, true},
                                {109, "lambda.7 left", 4.0, 0.1, 8000.0, 0.3, 0.12, true, true},
                                {131, "lambda.6", 4.0, 0.1, 1000.0, 0.3, 0.12, true, true},
                                {132, "lambda.6 left", 4.0, 0.1, 1000.0, 0.3, 0.12, true, true},
                                {203, "lambda.3", 4.0, 0.0, 1000.0, 0.0, 0.12},
                                {-1, "device"}};

}  // namespace

const DhdModel& dhd_model(int type) noexcept {
  for (const DhdModel& model : kModels) {
    if (model.type == type) return model;
  }
  return kModels[std::size(kModels) - 1];
}

}  // namespace thigma::detail
