// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/BuildingObstacles.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace scenery
{

namespace
{

std::string_view nameOf(const Building& building)
{
    return building.openings == Openings::hangar ? "hangar" : "building";
}

/// The direction of the longest edge of a ring.
glm::dvec2 longestEdge(const std::vector<glm::dvec2>& ring)
{
    glm::dvec2 longest(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 edge = ring[(i + 1) % ring.size()] - ring[i];
        if (glm::length(edge) > glm::length(longest)) longest = edge;
    }
    const double length = glm::length(longest);
    return length > 1e-6 ? longest / length : glm::dvec2(1.0, 0.0);
}

/// Where a line, parallel to `along` and `beside` it, crosses the rings: ascending, inside between each two.
std::vector<double> crossingsOf(const std::vector<std::vector<glm::dvec2>>& rings, const glm::dvec2& along,
                                double beside)
{
    const glm::dvec2 across(-along.y, along.x);
    std::vector<double> crossings;
    for (const std::vector<glm::dvec2>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 from = ring[i], to = ring[(i + 1) % ring.size()];
            const double low = glm::dot(from, across) - beside, high = glm::dot(to, across) - beside;
            if ((low < 0.0) == (high < 0.0)) continue;
            crossings.push_back(glm::dot(from + low / (low - high) * (to - from), along));
        }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
}

/// How much of the roof's height stands over a place between both eaves, 0…1 across the ridge.
double heightShare(RoofForm form, double share)
{
    switch (form)
    {
    case RoofForm::flat:
        return 1.0;
    case RoofForm::skillion:
        return 0.5;
    case RoofForm::round:
        return std::sqrt(std::max(0.0, 4.0 * share * (1.0 - share)));
    default:
        return 1.0 - std::abs(2.0 * share - 1.0);
    }
}

void addRoof(const StandingBuilding& standing, simulation::ObstacleList& obstacles)
{
    constexpr double kSlabM = 0.3, kNarrowestM = 1.0, kStrips = 6.0;
    const Building& building = standing.building;
    const std::vector<glm::dvec2>& outer = building.rings.front();
    glm::dvec2 along = longestEdge(outer);
    if (building.isRidgeAcross) along = {-along.y, along.x};
    const glm::dvec2 across(-along.y, along.x);
    double least = 1e9, most = -1e9;
    for (const glm::dvec2& corner : outer)
    {
        least = std::min(least, glm::dot(corner, across));
        most = std::max(most, glm::dot(corner, across));
    }
    const double widthM = std::max(kNarrowestM, (most - least) / kStrips);
    const int strips = std::max(1, static_cast<int>(std::ceil((most - least) / widthM - 1e-9)));
    const double stripM = (most - least) / strips, eavesM = standing.floorM + building.eavesM;
    for (int strip = 0; strip < strips; ++strip)
    {
        const double beside = least + (strip + 0.5) * stripM;
        const std::vector<double> crossings = crossingsOf(building.rings, along, beside);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        {
            simulation::Obstacle part = simulation::pieceBetween(
                simulation::ObstacleKind::house, crossings[i] * along + beside * across,
                crossings[i + 1] * along + beside * across, stripM);
            part.lowM = eavesM - kSlabM;
            part.highM = eavesM + building.roofM * heightShare(building.roof, (strip + 0.5) / strips);
            obstacles.add(part, nameOf(building));
        }
    }
}

} // namespace

void addObstacles(const std::vector<StandingBuilding>& buildings, simulation::ObstacleList& obstacles)
{
    for (const StandingBuilding& standing : buildings)
    {
        const Building& building = standing.building;
        if (building.isOnPosts) continue;
        for (const std::vector<glm::dvec2>& ring : building.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
            {
                const glm::dvec2 from = ring[i], to = ring[(i + 1) % ring.size()];
                simulation::Obstacle wall =
                    simulation::pieceBetween(simulation::ObstacleKind::house, from, to, kObstacleWallM);
                // Outer rings are counter-clockwise, courtyards clockwise: the inside lies to the left.
                wall.middle += 0.5 * kObstacleWallM * glm::dvec2(-wall.along.y, wall.along.x);
                wall.lowM = building.liftedM > 0.0 ? standing.floorM + building.liftedM : standing.footM;
                wall.highM = standing.floorM + building.eavesM;
                obstacles.add(wall, nameOf(building));
            }
    }
}

void addRoofs(const std::vector<StandingBuilding>& buildings, simulation::ObstacleList& obstacles)
{
    for (const StandingBuilding& standing : buildings)
        if (!standing.building.rings.empty() && standing.building.rings.front().size() > 2)
            addRoof(standing, obstacles);
}

} // namespace scenery
