// SPDX-License-Identifier: Apache-2.0
// Source: Ericson, *Real-Time Collision Detection*, 2005, 4.4.1 (separating axes of boxes).
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace simulation
{

/// A body in the plan: a rectangle, and where its length points to. Units: metres.
struct BodyBox
{
    glm::dvec2 middle{0.0}, along{1.0, 0.0};
    double halfLengthM = 0.0, halfWidthM = 0.0;
};

/// Whether two bodies overlap, or are not farther apart than `roomM` along the sides of either.
inline bool areMeeting(const BodyBox& a, const BodyBox& b, double roomM = 0.0)
{
    const glm::dvec2 apart = b.middle - a.middle;
    const double cosine = std::fabs(glm::dot(a.along, b.along));
    const double sine = std::fabs(a.along.x * b.along.y - a.along.y * b.along.x);
    const auto meetAlong = [&](const BodyBox& own, const BodyBox& other)
    {
        const double lengthwise =
            own.halfLengthM + cosine * other.halfLengthM + sine * other.halfWidthM + roomM;
        const double sideways = own.halfWidthM + cosine * other.halfWidthM + sine * other.halfLengthM + roomM;
        return std::fabs(glm::dot(apart, own.along)) <= lengthwise &&
               std::fabs(own.along.x * apart.y - own.along.y * apart.x) <= sideways;
    };
    return meetAlong(a, b) && meetAlong(b, a);
}

} // namespace simulation
