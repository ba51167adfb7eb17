// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include <osgPMObjects/core/tessellate/HoleBridges.h>
#include <osgPMObjects/core/tessellate/PolygonOutline.h>

namespace osgPMObjects::core
{

namespace
{

std::optional<foundation::Error> refusal(std::span<const glm::dvec3> corners,
                                         std::span<const std::uint32_t> contourSizes)
{
    const std::uint64_t sum = std::accumulate(contourSizes.begin(), contourSizes.end(), std::uint64_t(0));
    if (sum != corners.size())
        return foundation::Error{"polygon",
                                 "its contours ask for " + std::to_string(sum) + " corners, there are " +
                                     std::to_string(corners.size()),
                                 "give each contour its number of corners"};
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (!std::isfinite(corners[i].x) || !std::isfinite(corners[i].y) || !std::isfinite(corners[i].z))
            return foundation::Error{"polygon, corner " + std::to_string(i), "a coordinate is not finite",
                                     "leave the corner out, or mend it where it was made"};
    return std::nullopt;
}

struct Plane
{
    std::optional<NodedEdges> noded;
    bool isAlongAverageNormal = false;
};

Plane nodedPlane(std::span<const glm::dvec3> corners, std::span<const std::uint32_t> contourSizes,
                 ProjectionRule rule)
{
    const auto along = [&](ProjectionRule tried)
    {
        return Plane{nodeEdges(projectPolygon(corners, contourSizes, tried), contourSizes),
                     tried == ProjectionRule::averageNormal};
    };
    if (rule != ProjectionRule::automatic) return along(rule);
    Plane flat = along(ProjectionRule::largestArea);
    if (flat.noded && flat.noded->crossings == 0) return flat;
    Plane average = along(ProjectionRule::averageNormal);
    const bool isBetter = average.noded && (!flat.noded || average.noded->crossings < flat.noded->crossings);
    return isBetter ? std::move(average) : std::move(flat);
}

std::uint32_t countUnused(const std::vector<Loop>& loops, std::size_t corners)
{
    std::vector<char> isUsed(corners, 0);
    for (const Loop& loop : loops)
        for (const std::uint32_t point : loop)
            if (point < corners) isUsed[point] = 1;
    return static_cast<std::uint32_t>(corners) - std::accumulate(isUsed.begin(), isUsed.end(), 0u);
}

} // namespace

foundation::Result<PolygonOutline> outlinePolygon(std::span<const glm::dvec3> corners,
                                                  std::span<const std::uint32_t> contourSizes,
                                                  const OutlineOptions& options)
{
    if (auto refused = refusal(corners, contourSizes)) return *std::move(refused);
    Plane plane = nodedPlane(corners, contourSizes, options.projection);
    if (!plane.noded)
        return foundation::Error{"polygon",
                                 "its edges cross in places too near to one another to be told apart",
                                 "divide the polygon, or merge its corners"};
    NodedEdges& noded = *plane.noded;
    PolygonOutline outline;
    const std::vector<Loop> borders = insideLoops(noded, options.inside);
    outline.loops = bridgeHoles(noded.points, borders);
    outline.bridges = static_cast<std::uint32_t>(borders.size() - outline.loops.size());
    outline.crossings = noded.crossings;
    outline.unusedCorners = countUnused(borders, corners.size());
    outline.isSnapped = noded.isSnapped;
    outline.isAlongAverageNormal = plane.isAlongAverageNormal;
    outline.inserted = std::move(noded.inserted);
    outline.points = std::move(noded.points);
    return outline;
}

glm::dvec3 positionOf(const InsertedPoint& inserted, std::span<const glm::dvec3> corners)
{
    glm::dvec3 position(0.0);
    for (std::size_t i = 0; i < inserted.corners.size(); ++i)
        position += inserted.weights[i] * corners[inserted.corners[i]];
    return position;
}

} // namespace osgPMObjects::core
