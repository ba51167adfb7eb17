// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <osgPMObjects/core/tessellate/EarClipping.h>
#include <osgPMObjects/core/tessellate/Orientation.h>

#include "TestPolygons.h"

namespace testsupport
{

using osgPMObjects::core::orientation;
using osgPMObjects::core::Triangle;

inline double areaOf(const std::vector<glm::dvec2>& points, const Triangle& t)
{
    const glm::dvec2 u = points[t[1]] - points[t[0]], v = points[t[2]] - points[t[0]];
    return 0.5 * (u.x * v.y - u.y * v.x);
}

/// Tells whether two triangles overlap: they do unless the line through an edge of one has the other on its
/// outer side.
inline bool overlap(const std::vector<glm::dvec2>& points, const Triangle& s, const Triangle& t)
{
    const auto parts = [&](const Triangle& a, const Triangle& b)
    {
        for (int i = 0; i < 3; ++i)
        {
            bool isOutside = true;
            for (const std::uint32_t corner : b)
                isOutside =
                    isOutside && orientation(points[a[i]], points[a[(i + 1) % 3]], points[corner]) <= 0.0;
            if (isOutside) return true;
        }
        return false;
    };
    return !parts(s, t) && !parts(t, s);
}

/// Returns the defect of triangles that should fill a polygon of that area; empty: none. `points`: those of
/// the polygon in its plane (at most 1 in size), and what was inserted. Overlaps and orientation exactly, by
/// brute force.
inline std::string defectOf(const std::vector<glm::dvec2>& points, const std::vector<Triangle>& triangles,
                            double area, double tolerance = 1e-9)
{
    double sum = 0.0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Triangle& t : triangles)
    {
        if (orientation(points[t[0]], points[t[1]], points[t[2]]) <= 0.0)
            return "a triangle is turned over or flat";
        sum += areaOf(points, t);
        for (int i = 0; i < 3; ++i)
            if (++edges[{t[i], t[(i + 1) % 3]}] > 1) return "two triangles lie on the same side of an edge";
    }
    if (std::abs(sum - area) > tolerance * std::max(area, 1e-3))
        return "area " + std::to_string(sum) + " instead of " + std::to_string(area);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(points, triangles[i], triangles[j])) return "two triangles overlap";
    return {};
}

/// Tells whether a corner of a triangle lies on the border of another without being a corner of it.
inline bool hasTJunction(const std::vector<glm::dvec2>& points, const std::vector<Triangle>& triangles)
{
    for (const Triangle& t : triangles)
        for (int i = 0; i < 3; ++i)
        {
            const glm::dvec2 &a = points[t[i]], &b = points[t[(i + 1) % 3]];
            for (const Triangle& other : triangles)
                for (const std::uint32_t corner : other)
                {
                    const glm::dvec2& p = points[corner];
                    if (p != a && p != b && orientation(a, b, p) == 0.0 && glm::dot(p - a, p - b) < 0.0)
                        return true;
                }
        }
    return false;
}

} // namespace testsupport
