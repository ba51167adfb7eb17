// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <osgPMObjects/core/selection/SelectionSettings.h>
#include <osgPMObjects/core/selection/Switch.h>

namespace osgPMObjects::core
{

/// The names of the values of an enumeration in scene files, by their numbers.
inline std::array<const char*, kSelectionMethods> sceneFileNames(SelectionMethod)
{
    std::array<const char*, kSelectionMethods> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = nameOf(static_cast<SelectionMethod>(i));
    return names;
}
constexpr auto sceneFileNames(ErrorKind)
{
    return std::array{"maximum", "root-mean-square"};
}
constexpr auto sceneFileNames(SwitchMethod)
{
    return std::array{"discrete", "blend", "alpha", "continuous", "geomorph"};
}
constexpr auto sceneFileNames(BlendProfile)
{
    return std::array{"cross", "over"};
}

} // namespace osgPMObjects::core
