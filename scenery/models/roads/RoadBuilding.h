// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// Makes a building of an outline: plastered walls to the height of each corner, a flat roof, and walls 1 m
/// into the ground.
/// `corners`: on the ground, either way round; `heights`: of the walls above them, metres. Precondition:
/// three corners or more.
Model makeOutlineBuilding(std::vector<glm::dvec3> corners, std::vector<double> heights);

} // namespace scenery::models
