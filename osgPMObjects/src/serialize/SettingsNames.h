// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace osgPMObjects
{

/// The names of switch methods and blend profiles in scene files, by their values.
inline constexpr std::array kSwitchNames{"discrete", "blend", "alpha", "continuous", "geomorph"};
inline constexpr std::array kProfileNames{"cross", "over"};

} // namespace osgPMObjects
