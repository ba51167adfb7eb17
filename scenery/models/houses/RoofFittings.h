// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/houses/HouseShell.h"

namespace scenery::models
{

/// Adds a brick chimney with its pots through the roof at a point.
void addChimney(ModelBuilder& builder, const HouseShell& shell, const glm::dvec2& place, double aboveRidgeM);

/// Adds a window high up in both gables, in a frame in front of the wall.
void addGableWindows(ModelBuilder& builder, const HouseShell& shell);

/// Adds a dormer with a gable roof to the front slope, its window `insideM` behind the wall.
void addDormer(ModelBuilder& builder, const HouseShell& shell, double atX, double insideM);

} // namespace scenery::models
