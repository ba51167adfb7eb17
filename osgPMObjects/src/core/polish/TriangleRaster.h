// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// Calls `visit(pixel, shares)` for the pixels whose centres a triangle covers, edges included; pixels are
/// numbered row by row, `shares` are barycentric coordinates. x and y of the corners are in pixels; z is
/// ignored. A triangle without area covers nothing. Equal triangles cover equal pixels. Cost: linear in rows
/// and pixels.
template<class Visit>
void rasterise(const std::array<glm::dvec3, 3>& corners, int sizePx, const Visit& visit)
{
    const glm::dvec3 &a = corners[0], &b = corners[1], &c = corners[2];
    const double doubleArea = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (!(std::abs(doubleArea) > 1e-12)) return;
    const double inverse = 1.0 / doubleArea;
    // Coordinates of b and c are linear in x: s = s0 + x * ds; that of a is the rest.
    const double dsb = (c.y - a.y) * inverse, dsc = -(b.y - a.y) * inverse;
    const int lowest = std::max(0, static_cast<int>(std::ceil(std::min({a.y, b.y, c.y}) - 0.5)));
    const int highest = std::min(sizePx - 1, static_cast<int>(std::floor(std::max({a.y, b.y, c.y}) - 0.5)));
    for (int row = lowest; row <= highest; ++row)
    {
        const double y = row + 0.5 - a.y;
        const double sb0 = -(c.x - a.x) * y * inverse - (a.x - 0.5) * dsb;
        const double sc0 = (b.x - a.x) * y * inverse - (a.x - 0.5) * dsc;
        double from = 0.0, to = sizePx - 1;
        const auto clip = [&](double s0, double ds) // where s0 + x * ds >= 0
        {
            if (ds > 0.0)
                from = std::max(from, -s0 / ds);
            else if (ds < 0.0)
                to = std::min(to, -s0 / ds);
            else if (s0 < 0.0)
                to = -1.0;
        };
        clip(sb0, dsb);
        clip(sc0, dsc);
        clip(1.0 - sb0 - sc0, -dsb - dsc);
        if (from > to) continue;
        const int last = static_cast<int>(std::floor(to));
        for (int x = static_cast<int>(std::ceil(from)); x <= last; ++x)
        {
            const double sb = sb0 + x * dsb, sc = sc0 + x * dsc;
            visit(static_cast<std::uint32_t>(row * sizePx + x), glm::dvec3(1.0 - sb - sc, sb, sc));
        }
    }
}

} // namespace osgPMObjects::core
