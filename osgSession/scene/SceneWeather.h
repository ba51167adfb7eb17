// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <osg/Vec3d>
#include <osgSky/Atmosphere>

#include "simulation/environment/CloudLayer.h"
#include "simulation/environment/Hydrometeors.h"
#include "simulation/state/EnvironmentState.h"

namespace trainer
{

/// What falls, by the environment of a scenario. A precipitation whose intensity is not told has 4 mm an
/// hour.
simulation::Hydrometeors fallingOf(const simulation::EnvironmentState& environment);

/// Sun, fog, and the haze of what falls; no clouds.
osgSky::AtmosphereSettings airOf(const simulation::EnvironmentState& environment);

/// The clouds that an environment tells, by eighths of the sky or by a word; rain and snow under a sky of
/// which nothing is told come from a full cover. Absent: nothing is told, and nothing falls.
std::optional<std::vector<simulation::CloudLayer>> cloudsOf(const simulation::EnvironmentState& environment);

/// How much greyer and darker than a clear one the whole sky is that clouds cover by a share, 0 … 1: up to
/// half of it not at all.
double greyUnder(double cover);

/// The wind. Frame: the scene's, which is the scenario's. Units: m/s.
osg::Vec3d windOf(const simulation::EnvironmentState& environment);

} // namespace trainer
