// SPDX-License-Identifier: Apache-2.0
#include <osgRoads/core/place/RoadBed.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/surface/PavedGap.h>

#include "JunctionCover.h"

namespace osgRoads::core
{

bool isPavedGap(const PlacedNetwork& network, const glm::dvec2& plan)
{
    const double vergeM = RoadBed{}.vergeM;
    for (const RoadMatch& match : network.locator().within(plan, vergeM))
    {
        const Road& road = network.road(match.position.road);
        const JunctionCover cover(network, match.position.road);
        if (!cover.canCoverMarks() || cover.hasOwnPaving(match.position.s)) continue;
        const RoadExtent extent = extentAt(road, match.position.s);
        const int side = match.position.t > extent.leftT ? 1 : match.position.t < extent.rightT ? -1 : 0;
        const double outerT = side > 0 ? extent.leftT + vergeM : extent.rightT - vergeM;
        if (side != 0 && cover.isGap(match.position.s, outerT, side)) return true;
    }
    return false;
}

} // namespace osgRoads::core
