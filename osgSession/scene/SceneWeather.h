// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Vec3d>
#include <osgSky/Atmosphere>

#include "simulation/environment/Hydrometeors.h"
#include "simulation/state/EnvironmentState.h"

namespace trainer
{

/// What falls, by the environment of a scenario. A precipitation whose intensity is not told has 4 mm an
/// hour.
simulation::Hydrometeors fallingOf(const simulation::EnvironmentState& environment);

/// Sun, clouds, fog, and the haze of what falls. Rain and snow under a sky of which nothing is told come from
/// a full cover of clouds.
osgSky::AtmosphereSettings airOf(const simulation::EnvironmentState& environment);

/// The wind. Frame: the scene's, which is the scenario's. Units: m/s.
osg::Vec3d windOf(const simulation::EnvironmentState& environment);

/// How wet roads look, 0 … 1: 0.5 moist, 0.8 wet, 1 with puddles and under water; rain wets a road that is
/// told to be dry.
float roadWetnessOf(const simulation::EnvironmentState& environment);

} // namespace trainer
