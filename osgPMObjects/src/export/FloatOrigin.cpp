// SPDX-License-Identifier: Apache-2.0
#include "FloatOrigin.h"

#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/mesh/Extent.h>

namespace osgPMObjects
{

namespace
{

/// The ratio of distance to size above which a mesh gets an origin: below it, floats keep 3e-7 of the size.
constexpr double kFarAway = 4.0;

double largest(const glm::dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

glm::dvec3 floatOrigin(std::span<const glm::dvec3> positions)
{
    if (positions.empty()) return glm::dvec3(0.0);
    const core::Extent extent = core::extentOf(positions);
    const glm::dvec3 centre = 0.5 * (extent.low + extent.high);
    return largest(centre) > kFarAway * largest(extent.high - extent.low) ? centre : glm::dvec3(0.0);
}

} // namespace osgPMObjects
