// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scenery/buildings/BuildingFacets.h"

namespace scenery
{

/// Adds plain bodies to facets, in a frame about `origin`. Units: metres; colours as display values.
class Beams
{
public:
    Beams(Facets& facets, const glm::dvec3& origin) : _facets(facets), _origin(origin) {}

    void colour(const glm::vec3& colour) { _colour = colour; }

    /// A straight bar of `sides` (3 or more) without ends, thinner at `to` where its radius there is smaller.
    void bar(const glm::dvec3& from, const glm::dvec3& to, double fromRadiusM, double toRadiusM,
             int sides = 3);
    void bar(const glm::dvec3& from, const glm::dvec3& to, double radiusM)
    {
        bar(from, to, radiusM, radiusM);
    }

    /// An upright slab along two places: its foot below them, its top above, closed but for the bottom.
    /// `across`: half its width, a horizontal vector to the left.
    struct Slab
    {
        glm::dvec3 from, to; ///< in the middle of its top
        glm::dvec2 across;
        double fromFootM, toFootM; ///< height of its lower edges
    };
    void slab(const Slab& slab);

    /// A box along the axes of a frame: `forward` is a horizontal unit vector.
    void box(const glm::dvec3& middle, const glm::dvec2& forward, const glm::dvec3& halfM);

    /// Four corners of a plane, counter-clockwise seen from outside.
    void face(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

private:
    Facets& _facets;
    glm::dvec3 _origin;
    glm::vec3 _colour{0.6F};
};

} // namespace scenery
