// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgRoads/core/network/LaneType.h>

namespace osgRoads::core
{

bool isForCars(LaneType type)
{
    constexpr std::array kTypes = {
        LaneType::driving, LaneType::bidirectional,  LaneType::entry,    LaneType::exit, LaneType::offRamp,
        LaneType::onRamp,  LaneType::connectingRamp, LaneType::slipLane, LaneType::bus,  LaneType::taxi,
        LaneType::hov};
    return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

std::string_view wordOf(LaneType type)
{
    for (const auto& [word, value] : kLaneTypes)
        if (value == type) return word;
    return "none";
}

} // namespace osgRoads::core
