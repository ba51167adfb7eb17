// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace osgPMObjects::core
{

/// An axis-aligned box; empty while nothing has been added.
struct Extent
{
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};

    void add(const glm::dvec3& p)
    {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }

    bool isEmpty() const { return low.x > high.x; }
    bool contains(const Extent& other) const
    {
        return glm::all(glm::lessThanEqual(low, other.low)) &&
               glm::all(glm::greaterThanEqual(high, other.high));
    }

    /// Length of the diagonal, the unit of relative tolerances; 0 while empty.
    double diagonal() const { return isEmpty() ? 0.0 : glm::length(high - low); }
};

inline Extent extentOf(std::span<const glm::dvec3> points)
{
    Extent extent;
    for (const glm::dvec3& p : points)
        extent.add(p);
    return extent;
}

} // namespace osgPMObjects::core
