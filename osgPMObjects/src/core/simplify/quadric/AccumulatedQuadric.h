// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/geometric.hpp>

#include <osgPMObjects/core/simplify/Quadric.h>

namespace osgPMObjects::core
{

/// A quadric that adds up: the weighted squared distances from the planes of all faces that were ever around
/// the positions that have become one. Its planes need not pass through its origin, which is the position.
/// Source: Garland and Heckbert, *Surface simplification using quadric error metrics* (1997), section 4.
/// Differs: the origin goes with the position, as that of Quadric.
struct AccumulatedQuadric
{
    Quadric planes;
    glm::dvec3 linear{0.0};
    double constant = 0.0;

    double at(const glm::dvec3& fromOrigin) const
    {
        return planes.at(fromOrigin) + 2.0 * glm::dot(linear, fromOrigin) + constant;
    }

    /// The same about another origin.
    AccumulatedQuadric about(const glm::dvec3& fromOrigin) const
    {
        return {planes, linear + planes.matrix() * fromOrigin, at(fromOrigin)};
    }
};

/// The sum of two quadrics with one origin.
inline AccumulatedQuadric operator+(AccumulatedQuadric a, const AccumulatedQuadric& b)
{
    a.planes += b.planes;
    a.linear += b.linear;
    a.constant += b.constant;
    return a;
}

} // namespace osgPMObjects::core
