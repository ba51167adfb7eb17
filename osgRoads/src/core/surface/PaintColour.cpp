// SPDX-License-Identifier: Apache-2.0
#include "PaintColour.h"

namespace osgRoads::core
{

glm::vec3 paintOf(MarkColour colour)
{
    switch (colour)
    {
    case MarkColour::black:
        return {0.02F, 0.02F, 0.02F};
    case MarkColour::blue:
        return {0.03F, 0.12F, 0.50F};
    case MarkColour::green:
        return {0.03F, 0.30F, 0.10F};
    case MarkColour::orange:
        return {0.70F, 0.25F, 0.02F};
    case MarkColour::red:
        return {0.50F, 0.03F, 0.03F};
    case MarkColour::violet:
        return {0.25F, 0.06F, 0.40F};
    case MarkColour::yellow:
        return {0.70F, 0.48F, 0.04F};
    default:
        return {0.72F, 0.72F, 0.70F};
    }
}

} // namespace osgRoads::core
