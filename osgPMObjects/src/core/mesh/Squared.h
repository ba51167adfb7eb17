// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgPMObjects::core
{

/// The square of a number.
constexpr double squared(double x)
{
    return x * x;
}

} // namespace osgPMObjects::core
