// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

inline LevelError sumOf(const LevelError& a, const LevelError& b)
{
    return {a.distance + b.distance, a.normal + b.normal, a.texCoord + b.texCoord, a.colour + b.colour};
}

inline LevelError largerOf(const LevelError& a, const LevelError& b)
{
    return {std::max(a.distance, b.distance), std::max(a.normal, b.normal), std::max(a.texCoord, b.texCoord),
            std::max(a.colour, b.colour)};
}

/// Returns the error of a level after a step: at least that of the level before. `step`: of the step alone,
/// with the distance in units of `length`.
inline LevelError raisedBy(const LevelError& step, double length, const LevelError& before)
{
    constexpr float kMostNormal = 2.0f, kMostColour = 1.0f; // the largest possible differences
    return largerOf(before, {static_cast<float>(step.distance * length), std::min(step.normal, kMostNormal),
                             step.texCoord, std::min(step.colour, kMostColour)});
}

} // namespace osgPMObjects::core
