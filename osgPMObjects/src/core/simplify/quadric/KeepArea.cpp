// SPDX-License-Identifier: Apache-2.0
#include "KeepArea.h"

#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

namespace
{

/// Calls `visit(spoked)` for the faces that remain when both middles merge.
template<class Visit>
void visitRemaining(const MergingStars& stars, const Visit& visit)
{
    for (const Star::Spoked& spoked : stars.from.faces)
        if (!spoked.has(stars.to.middle)) visit(spoked);
    for (const Star::Spoked& spoked : stars.to.faces)
        if (!spoked.has(stars.from.middle)) visit(spoked);
}

double doubleAreaBefore(const MergingStars& stars)
{
    double area = 0.0;
    for (const Star::Spoked& spoked : stars.from.faces)
        area += spoked.doubleArea;
    for (const Star::Spoked& spoked : stars.to.faces)
        if (!spoked.has(stars.from.middle)) area += spoked.doubleArea;
    return area;
}

double doubleAreaAt(const MergingStars& stars, const glm::dvec3& at)
{
    double area = 0.0;
    visitRemaining(stars,
                   [&](const Star::Spoked& spoked)
                   {
                       area += glm::length(glm::cross(stars.positions[spoked.second] - at,
                                                      stars.positions[spoked.third] - at));
                   });
    return area;
}

} // namespace

glm::dvec3 placeKeepingArea(const MergingStars& stars, const glm::dvec3& at, double most)
{
    constexpr int kHalvings = 16;
    glm::dvec3 ring(0.0);
    double corners = 0.0;
    visitRemaining(stars,
                   [&](const Star::Spoked& spoked)
                   {
                       ring += stars.positions[spoked.second] + stars.positions[spoked.third];
                       corners += 2.0;
                   });
    if (corners == 0.0) return at;
    const glm::dvec3 outwards = at - ring / corners;
    const double length = glm::length(outwards), before = doubleAreaBefore(stars);
    if (!(length > 0.0) || doubleAreaAt(stars, at) >= before) return at;
    double low = 0.0,
           high = most / length; // the area grows along the way: it is convex, and least inside of the ring
    const auto place = [&](double share) { return at + share * outwards; };
    if (doubleAreaAt(stars, place(high)) <= before) return place(high);
    for (int i = 0; i < kHalvings; ++i)
    {
        const double middle = 0.5 * (low + high);
        (doubleAreaAt(stars, place(middle)) < before ? low : high) = middle;
    }
    return place(low);
}

} // namespace osgPMObjects::core
