// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/ViewState.h>

namespace viewlod
{

/// The part of a scene that the cameras at one eye see, each widened by an angle on all four sides; without a
/// camera it is everything.
/// Balls nest: a ball that holds one in sight is in sight, too.
/// Frame: that of the views. Projections are perspective ones: their sides meet in the eye.
class Sight
{
public:
    /// Adds what a camera sees, and `marginRad` beyond its sides. Its near plane does not count, its far
    /// plane does. Units: radians, 0 or more; two sides that would be half a turn or more apart let
    /// everything in.
    void add(const ViewState& view, double marginRad)
    {
        const auto& planes = view.frustum.planes();
        Cone cone;
        for (std::size_t axis = 0; axis < 2; ++axis)
        {
            const auto sides = widened(planes[2 * axis], planes[2 * axis + 1], view.eyeWorld, marginRad);
            cone[2 * axis] = sides[0];
            cone[2 * axis + 1] = sides[1];
        }
        cone[4] = planes[5];
        _cones.push_back(cone);
    }

    /// Adds the cameras of another one: none where that is everything.
    void add(const Sight& other) { _cones.insert(_cones.end(), other._cones.begin(), other._cones.end()); }

    bool isEverything() const { return _cones.empty(); }

    /// Tells whether a ball may be in sight: false only where it is not.
    bool touches(const glm::dvec3& centre, double radius) const
    {
        return isEverything() ||
               std::any_of(_cones.begin(), _cones.end(),
                           [&](const Cone& cone)
                           {
                               return std::all_of(
                                   cone.begin(), cone.end(),
                                   [&](const glm::dvec4& plane)
                                   { return glm::dot(glm::dvec3(plane), centre) + plane.w >= -radius; });
                           });
    }

    bool operator==(const Sight&) const = default;

private:
    using Cone = std::array<glm::dvec4, 5>; ///< two sides, two sides, far; as in Frustum

    /// Turns two opposite sides of a frustum about the eye, away from each other.
    static std::array<glm::dvec4, 2> widened(const glm::dvec4& one, const glm::dvec4& other,
                                             const glm::dvec3& eye, double marginRad)
    {
        const glm::dvec3 a(one), b(other);
        const double between = std::acos(std::clamp(-glm::dot(a, b), -1.0, 1.0)); // from side to side
        constexpr double kHalfTurn = 3.14159265358979323846;
        if (between + 2.0 * marginRad >= kHalfTurn - 1e-6)
            return {glm::dvec4(0.0, 0.0, 0.0, 1e30), glm::dvec4(0.0, 0.0, 0.0, 1e30)};
        const glm::dvec3 middle = glm::normalize(a + b); // where both look
        const auto turned = [&](const glm::dvec3& side)
        {
            const glm::dvec3 across = glm::normalize(middle - glm::dot(middle, side) * side);
            const glm::dvec3 normal = std::cos(marginRad) * side + std::sin(marginRad) * across;
            return glm::dvec4(normal, -glm::dot(normal, eye));
        };
        return {turned(a), turned(b)};
    }

    std::vector<Cone> _cones;
};

} // namespace viewlod
