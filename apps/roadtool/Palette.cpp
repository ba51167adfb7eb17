// SPDX-License-Identifier: Apache-2.0
#include "roadtool/Palette.h"

namespace roadtool
{

Colour colourOf(osgRoads::core::LaneType type)
{
    using osgRoads::core::LaneType;
    switch (type)
    {
    case LaneType::sidewalk:
        return {188, 182, 172};
    case LaneType::shoulder:
    case LaneType::stop:
        return {122, 124, 126};
    case LaneType::biking:
        return {150, 96, 84};
    case LaneType::parking:
        return {108, 114, 130};
    case LaneType::bus:
    case LaneType::taxi:
        return {104, 92, 92};
    case LaneType::tram:
    case LaneType::rail:
        return {98, 90, 80};
    case LaneType::border:
    case LaneType::median:
        return {150, 166, 128};
    case LaneType::curb:
        return {160, 160, 160};
    default:
        return {88, 90, 94};
    }
}

Colour colourOf(osgRoads::core::MarkColour colour)
{
    using osgRoads::core::MarkColour;
    switch (colour)
    {
    case MarkColour::black:
        return {30, 30, 30};
    case MarkColour::blue:
        return {60, 100, 220};
    case MarkColour::green:
        return {50, 160, 80};
    case MarkColour::orange:
        return {240, 150, 40};
    case MarkColour::red:
        return {220, 50, 50};
    case MarkColour::violet:
        return {150, 70, 190};
    case MarkColour::yellow:
        return {245, 205, 50};
    default:
        return {255, 255, 255};
    }
}

} // namespace roadtool
