// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/RoadBuilding.h"

#include <algorithm>
#include <cmath>

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

namespace
{

constexpr double kDepthM = 1.0;
constexpr double kPictureM = 2.4; ///< the period of wall and roof pictures

double turnedArea(const std::vector<glm::dvec3>& corners)
{
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const glm::dvec3& a = corners[i];
        const glm::dvec3& b = corners[(i + 1) % corners.size()];
        area += 0.5 * (a.x * b.y - b.x * a.y);
    }
    return area;
}

/// Closes the roof by cutting ears off. Source: Meisters, *Polygons have ears*, 1975.
void addRoof(ModelBuilder& builder, std::vector<glm::dvec3> ring)
{
    const auto cross = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
    const auto corner = [](const glm::dvec3& at) { return Corner{at, {at.x / kPictureM, at.y / kPictureM}}; };
    while (ring.size() > 2)
    {
        std::size_t ear = 0;
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec3 &a = ring[(i + ring.size() - 1) % ring.size()], &b = ring[i],
                             &c = ring[(i + 1) % ring.size()];
            const bool isFree = std::none_of(ring.begin(), ring.end(),
                                             [&](const glm::dvec3& p)
                                             {
                                                 return p != a && p != b && p != c && cross(a, b, p) >= 0.0 &&
                                                        cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0;
                                             });
            if (cross(a, b, c) <= 1e-9 || !isFree) continue;
            ear = i;
            break;
        }
        builder.triangle(corner(ring[(ear + ring.size() - 1) % ring.size()]), corner(ring[ear]),
                         corner(ring[(ear + 1) % ring.size()]));
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
}

} // namespace

Model makeOutlineBuilding(std::vector<glm::dvec3> corners, std::vector<double> heights)
{
    if (turnedArea(corners) < 0.0)
    {
        std::reverse(corners.begin(), corners.end());
        std::reverse(heights.begin(), heights.end());
    }
    ModelBuilder builder;
    builder.begin("walls", {Painting::plaster, Coat::matt}, {0.90F, 0.86F, 0.78F});
    std::vector<glm::dvec3> top;
    double along = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const std::size_t next = (i + 1) % corners.size();
        const double length = std::hypot(corners[next].x - corners[i].x, corners[next].y - corners[i].y);
        const auto at = [&](std::size_t k, double up, double u) {
            return Corner{corners[k] + glm::dvec3(0.0, 0.0, up),
                          {u / kPictureM, (corners[k].z + up) / kPictureM}};
        };
        builder.quad(at(i, -kDepthM, along), at(next, -kDepthM, along + length),
                     at(next, heights[next], along + length), at(i, heights[i], along));
        top.push_back(corners[i] + glm::dvec3(0.0, 0.0, heights[i]));
        along += length;
    }
    builder.begin("roof", {Painting::roofMetal, Coat::matt}, {0.45F, 0.44F, 0.43F});
    addRoof(builder, top);
    return builder.finish();
}

} // namespace scenery::models
