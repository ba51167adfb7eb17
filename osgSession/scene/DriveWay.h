// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <foundation/Result.h>

#include "SceneTerrain.h"
#include "simulation/control/driver/DriverPath.h"
#include "simulation/vehicle/Ground.h"

namespace trainer
{

/// The way of a drive through the roads of a scene: `lengthM` of lanes where the network allows it, with the
/// stop signs and traffic lights of their roads. Errors (`file` is their place): no roads, or no lane for
/// cars.
foundation::Result<simulation::DriverPath> driveWay(const SceneTerrain& scene, const std::string& file,
                                                    double lengthM);

/// The ground of a scene as wheels meet it: on roads `paving`, or without one what their lanes are made of,
/// asphalt where they do not say; grass beside them, water where the sea is higher.
std::shared_ptr<const simulation::Ground> groundForWheels(const SceneTerrain& scene,
                                                          std::optional<simulation::GroundKind> paving = {});

} // namespace trainer
