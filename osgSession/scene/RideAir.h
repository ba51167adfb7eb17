// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/SceneTerrain.h"
#include "simulation/tour/RideConditions.h"

namespace trainer
{

/// The conditions of a ride over a scene: its world's sun, visibility and clouds stay where hour and weather
/// leave them.
inline simulation::RideConditions inAirOf(const SceneTerrain& scene, simulation::RideConditions conditions)
{
    conditions.keepsSun = scene.air.sun.has_value();
    conditions.keepsVisibility = scene.air.visibilityM.has_value();
    conditions.keepsClouds = scene.clouds.has_value();
    return conditions;
}

} // namespace trainer
