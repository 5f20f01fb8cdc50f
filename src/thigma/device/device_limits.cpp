#include "thigma/device/device_limits.h"

namespace thigma {
namespace {

constexpr DeviceModel kModels[] = {
    {.name = "falcon",
     .product = "Novint Falcon",
     .max_force = 8.0,
     .max_stiffness = 3000.0,
     .senses_rotation = false},
    {.name = "lambda.7",
     .product = "Force Dimension lambda.7",
     .max_stiffness = 8000.0,
     .actuates_rotation = true},
    {.name = "premium-1.5-6dof",
     .product = "3D Systems Phantom Premium 1.5 6DOF",
     .max_force = 8.5,
     .max_torque = 0.188,
     .max_stiffness = 800.0,
     .max_angular_stiffness = 0.3,
     .actuates_rotation = true},
    {.name = "premium-3.0", .product = "3D Systems Phantom Premium 3.0", .max_force = 22.0},
    {.name = "sigma.7",
     .product = "Force Dimension sigma.7",
     .max_force = 12.0,
     .max_torque = 0.2,
     .max_stiffness = 4000.0,
     .max_angular_stiffness = 1.0,
     .actuates_rotation = true},
    {.name = "touch", .product = "3D Systems Touch", .max_force = 3.3, .max_stiffness = 400.0},
};

}  // namespace

std::span<const DeviceModel> device_models() THIGMA_RT { return kModels; }

const DeviceModel* find_device_model(std::string_view name) THIGMA_RT {
  for (const DeviceModel& model : kModels) {
    if (model.name == name) return &model;
  }
  return nullptr;
}

}  // namespace thigma
