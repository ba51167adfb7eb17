// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// The point of a triangle nearest to p.
/// Source: Ericson, *Real-time collision detection* (2005), section 5.1.5 (Voronoi regions).
inline glm::dvec3 nearestPoint(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                               const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
    const double sum = va + vb + vc;
    return a + ab * (vb / sum) + ac * (vc / sum);
}

/// The distance along a ray to a triangle, in lengths of the direction; negative: no hit.
/// Source: Möller and Trumbore, *Fast, minimum storage ray/triangle intersection* (1997).
inline double rayDistance(const glm::dvec3& from, const glm::dvec3& direction, const glm::dvec3& a,
                          const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return -1.0;
    const glm::dvec3 t = from - a;
    const double u = glm::dot(t, p) / determinant;
    const glm::dvec3 q = glm::cross(t, ab);
    const double v = glm::dot(direction, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 ? glm::dot(ac, q) / determinant : -1.0;
}

} // namespace osgPMObjects::core
