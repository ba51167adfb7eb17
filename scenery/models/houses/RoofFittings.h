// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/houses/HouseShell.h"

namespace scenery::models
{

/// A chimney of bricks through the roof at a place, with its pots.
void addChimney(ModelBuilder& builder, const HouseShell& shell, const glm::dvec2& place, double aboveRidgeM);

/// A window high up in both gables, in a frame that stands proud of the wall.
void addGableWindows(ModelBuilder& builder, const HouseShell& shell);

/// A dormer with a saddle roof of its own on the front slope, its window `insideM` in from the wall.
void addDormer(ModelBuilder& builder, const HouseShell& shell, double atX, double insideM);

} // namespace scenery::models
