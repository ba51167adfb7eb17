// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace osgPMObjects::core
{

/// The numbers of its corners, counter-clockwise.
using Triangle = std::array<std::uint32_t, 3>;

/// Whether two corners are one.
constexpr bool repeatsCorner(const Triangle& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

} // namespace osgPMObjects::core
