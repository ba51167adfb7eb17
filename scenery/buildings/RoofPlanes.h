// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "scenery/buildings/Building.h"

namespace scenery
{

/// A roof as the lowest of a few planes over the plan. Any footprint has walls up to it, so no gap is left.
/// Frame: the plan of the building. Units: metres above the eaves.
class RoofPlanes
{
public:
    /// The planes of a building's roof, over the smallest rectangle around its outer ring.
    explicit RoofPlanes(const Building& building);

    double heightM(const glm::dvec2& place) const;

    /// The shares 0 … 1 of an edge at which the lowest plane changes, in order, without the ends.
    std::vector<double> breaksOn(const glm::dvec2& from, const glm::dvec2& to) const;

    /// Cuts a triangle of the plan into the parts that lie under one plane each, as convex polygons with the
    /// plane's gradient.
    struct Part
    {
        std::vector<glm::dvec2> corners;
        glm::dvec2 gradient{0.0};
    };
    std::vector<Part> partsOf(const std::array<glm::dvec2, 3>& triangle) const;

private:
    struct Plane
    {
        double zero = 0.0; ///< height at the origin
        glm::dvec2 gradient{0.0};
    };
    double heightOf(const Plane& plane, const glm::dvec2& place) const
    {
        return plane.zero + glm::dot(plane.gradient, place - _origin);
    }

    glm::dvec2 _origin{0.0};
    std::vector<Plane> _planes;
};

} // namespace scenery
