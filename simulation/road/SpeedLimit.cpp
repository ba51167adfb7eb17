// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/SpeedLimit.h"

#include <osgRoads/core/query/LaneSpan.h>

namespace simulation
{

std::optional<double> speedLimitAt(const RoadScene& roads, const RoadPlace& place)
{
    using osgRoads::core::lastStartingBy;
    const osgRoads::core::Road& road = roads.roadAt(place);
    const osgRoads::core::LaneSection* const section = osgRoads::core::sectionAt(road, place.s);
    if (const osgRoads::core::Lane* const lane = section ? section->lane(place.lane) : nullptr)
        if (const int index = lastStartingBy(lane->speeds, place.s - section->s); index >= 0)
            if (const auto& limit = lane->speeds[static_cast<std::size_t>(index)].metresPerSecond)
                return limit;
    const int index = lastStartingBy(road.kinds, place.s);
    return index < 0 ? std::nullopt : road.kinds[static_cast<std::size_t>(index)].metresPerSecond;
}

} // namespace simulation
