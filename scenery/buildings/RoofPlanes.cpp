// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/RoofPlanes.h"

#include <algorithm>
#include <cmath>

#include "scenery/buildings/Outline.h"

namespace scenery
{

namespace
{

constexpr double kLeastHalfM = 0.5;
constexpr int kArcPlanes = 3; ///< on either side of the ridge

/// Keeps the part of a convex polygon where `height` is not above 0 (its signed height at the corners).
std::vector<glm::dvec2> cutBelow(const std::vector<glm::dvec2>& polygon, const std::vector<double>& height)
{
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const std::size_t next = (i + 1) % polygon.size();
        if (height[i] <= 0.0) kept.push_back(polygon[i]);
        if ((height[i] <= 0.0) != (height[next] <= 0.0))
            kept.push_back(glm::mix(polygon[i], polygon[next], height[i] / (height[i] - height[next])));
    }
    return kept;
}

} // namespace

RoofPlanes::RoofPlanes(const Building& building)
{
    const PlanRectangle box = rectangleAround(building.rings.front());
    _origin = box.middle;
    glm::dvec2 along = box.along, across = box.across();
    double halfLength = std::max(box.halfLengthM, kLeastHalfM),
           halfWidth = std::max(box.halfWidthM, kLeastHalfM);
    if (building.isRidgeAcross)
    {
        std::swap(along, across);
        std::swap(halfLength, halfWidth);
    }
    const double top = building.roofM, slope = top / halfWidth;
    const auto add = [&](double zero, const glm::dvec2& gradient) { _planes.push_back({zero, gradient}); };
    switch (building.roof)
    {
    case RoofForm::flat:
        add(top, glm::dvec2(0.0));
        break;
    case RoofForm::skillion:
        add(0.5 * top, 0.5 * slope * across);
        break;
    case RoofForm::round: // what touches an arc of a circle from above
        for (int i = -kArcPlanes; i <= kArcPlanes; ++i)
        {
            const double radius = 0.5 * (halfWidth * halfWidth / std::max(top, 1e-3) + top);
            const double half = std::asin(std::min(halfWidth / radius, 1.0)),
                         angle = half * i / (kArcPlanes + 0.5);
            const double gradient = -std::tan(angle), at = radius * std::sin(angle);
            add(radius * std::cos(angle) - (radius - top) - gradient * at, gradient * across);
        }
        break;
    case RoofForm::hipped:
    case RoofForm::pyramidal:
    {
        const bool isHipped = building.roof == RoofForm::hipped && halfLength > halfWidth;
        const double endSlope = isHipped ? slope : top / halfLength;
        const double endZero = isHipped ? top + slope * (halfLength - halfWidth) : top;
        add(endZero, endSlope * along);
        add(endZero, -endSlope * along);
        [[fallthrough]];
    }
    case RoofForm::gabled:
        add(top, slope * across);
        add(top, -slope * across);
        break;
    }
}

double RoofPlanes::heightM(const glm::dvec2& place) const
{
    double lowest = heightOf(_planes.front(), place);
    for (const Plane& plane : _planes)
        lowest = std::min(lowest, heightOf(plane, place));
    return lowest;
}

std::vector<double> RoofPlanes::breaksOn(const glm::dvec2& from, const glm::dvec2& to) const
{
    std::vector<double> breaks;
    for (std::size_t i = 0; i < _planes.size(); ++i)
        for (std::size_t j = i + 1; j < _planes.size(); ++j)
        {
            const double a = heightOf(_planes[i], from) - heightOf(_planes[j], from);
            const double b = heightOf(_planes[i], to) - heightOf(_planes[j], to);
            if ((a < 0.0) == (b < 0.0) || a == b) continue;
            const double share = a / (a - b);
            const glm::dvec2 place = glm::mix(from, to, share);
            const bool isLowest = heightOf(_planes[i], place) < heightM(place) + 1e-6;
            if (share > 1e-3 && share < 1.0 - 1e-3 && isLowest) breaks.push_back(share);
        }
    std::sort(breaks.begin(), breaks.end());
    return breaks;
}

std::vector<RoofPlanes::Part> RoofPlanes::partsOf(const std::array<glm::dvec2, 3>& triangle) const
{
    std::vector<Part> parts;
    for (std::size_t i = 0; i < _planes.size(); ++i)
    {
        std::vector<glm::dvec2> polygon(triangle.begin(), triangle.end());
        for (std::size_t j = 0; j < _planes.size() && polygon.size() > 2; ++j)
        {
            if (j == i) continue;
            std::vector<double> above;
            for (const glm::dvec2& corner : polygon)
                above.push_back(heightOf(_planes[i], corner) - heightOf(_planes[j], corner));
            polygon = cutBelow(polygon, above);
        }
        if (polygon.size() > 2) parts.push_back({std::move(polygon), _planes[i].gradient});
    }
    return parts;
}

} // namespace scenery
