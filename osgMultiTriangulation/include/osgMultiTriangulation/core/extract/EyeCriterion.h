// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include <osgMultiTriangulation/core/structure/MultiTriangulation.h>

namespace osgMultiTriangulation::core
{

/// Tells whether a triangle is too coarse for an eye: the criterion of an Extraction for pictures in
/// perspective. No point of the surface is drawn farther from its place than errorPerDistance says, with the
/// distance of the nearer of the two.
/// Frame: metres (or the units of the plan) from the lattice's point `corner`, heights as they are.
struct EyeCriterion
{
    glm::dvec3 eye{0.0};
    glm::dvec2 step{1.0}, corner{0.0}; ///< of the lattice
    double errorPerDistance = 0.0;     ///< pixels allowed per pixels a unit of tangent has
    double nearest = 1.0;              ///< distance nearer than which nothing is promised
    double spare = 0.0;                ///< how far the eye may move before the surface is drawn

    bool operator()(const MultiTriangulation& tree, std::uint32_t triangle) const
    {
        const double error = tree.errors[triangle];
        if (error <= errorPerDistance * nearest) return false;
        return error > errorPerDistance * std::max(distanceTo(tree, triangle) - error - spare, nearest);
    }

    /// The distance from the eye to the box around a triangle.
    double distanceTo(const MultiTriangulation& tree, std::uint32_t triangle) const
    {
        const Triangle& corners = tree.corners[triangle];
        const SurfacePoint &a = tree.points[corners[0]], &b = tree.points[corners[1]],
                           &c = tree.points[corners[2]];
        const auto beyond = [](double low, double high, double at) {
            return std::max({low - at, at - high, 0.0});
        };
        const double x = beyond(step.x * (std::min({a.x, b.x, c.x}) - corner.x),
                                step.x * (std::max({a.x, b.x, c.x}) - corner.x), eye.x);
        const double y = beyond(step.y * (std::min({a.y, b.y, c.y}) - corner.y),
                                step.y * (std::max({a.y, b.y, c.y}) - corner.y), eye.y);
        const double z =
            beyond(std::min({a.height, b.height, c.height}), std::max({a.height, b.height, c.height}), eye.z);
        return std::sqrt(x * x + y * y + z * z);
    }
};

} // namespace osgMultiTriangulation::core
