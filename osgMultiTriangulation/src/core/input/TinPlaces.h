// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/input/PointSet.h>

namespace osgMultiTriangulation::core
{

/// Tells that a file of triangles has two points above each other.
inline foundation::Error twoHeightsAt(const std::string& name, const MeasuredPoint& p)
{
    return {name, "has two heights at (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ")",
            "leave out walls and overhangs: each place has one height"};
}

/// Tells that a triangle of a file is vertical or a needle. `p`: its first corner.
inline foundation::Error noAreaAt(const std::string& name, std::uint64_t triangle, const MeasuredPoint& p)
{
    return {name,
            "triangle " + std::to_string(triangle) + " at (" + std::to_string(p[0]) + ", " +
                std::to_string(p[1]) + ") has no area in the plan",
            "leave out walls and needles"};
}

} // namespace osgMultiTriangulation::core
