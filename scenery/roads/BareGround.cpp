// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/BareGround.h"

#include <osgRoads/core/surface/PavedGap.h>

namespace scenery
{

bool isBareByRoads(const osgRoads::core::PlacedNetwork& roads, const glm::dvec3& place)
{
    constexpr double kFromLanesM = 0.6; // the gravel beside them is bare
    const glm::dvec2 plan(roads.toInertial(place));
    return !roads.locator().within(plan, kFromLanesM).empty() || osgRoads::core::isPavedGap(roads, plan);
}

} // namespace scenery
