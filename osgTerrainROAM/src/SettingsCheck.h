// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>
#include <string>

#include <foundation/Result.h>

namespace osgTerrainROAM
{

/// A requirement that one setting has to meet.
struct SettingRequirement
{
    bool isMet;
    const char* name;
    double value;
    const char* allowed; ///< completes the sentence "give …"
};

/// Checks requirements in order. Errors: the first one that is not met, at the place "`owner`.name".
inline foundation::Outcome checkRequirements(const std::string& owner,
                                             std::span<const SettingRequirement> requirements)
{
    for (const SettingRequirement& requirement : requirements)
        if (!requirement.isMet)
            return foundation::Error{owner + "." + requirement.name,
                                     std::to_string(requirement.value) + " is not allowed",
                                     std::string("give ") + requirement.allowed};
    return foundation::success();
}

inline bool isFiniteAbove0(double value)
{
    return std::isfinite(value) && value > 0.0;
}

inline bool isFiniteFrom0(double value)
{
    return std::isfinite(value) && value >= 0.0;
}

} // namespace osgTerrainROAM
