// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/BuildingObstacles.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "scenery/buildings/Outline.h"
#include "scenery/buildings/RoofPlanes.h"

namespace scenery
{

namespace
{

std::string_view nameOf(const Building& building)
{
    return building.openings == Openings::hangar ? "hangar" : "building";
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

void addRoof(const StandingBuilding& standing, simulation::ObstacleList& obstacles)
{
    constexpr double kSlabM = 0.3, kNarrowestM = 1.0, kStrips = 6.0;
    const Building& building = standing.building;
    const RoofPlanes roof(building);
    const PlanRectangle box = rectangleAround(building.rings.front());
    const glm::dvec2 along = building.isRidgeAcross ? box.across() : box.along, across(-along.y, along.x);
    const double widthM = 2.0 * (building.isRidgeAcross ? box.halfLengthM : box.halfWidthM);
    const double wishedM = std::max(kNarrowestM, widthM / kStrips);
    const int strips = std::max(1, static_cast<int>(std::ceil(widthM / wishedM - 1e-9)));
    const double stripM = widthM / strips, firstM = glm::dot(box.middle, across) - 0.5 * widthM;
    const double eavesM = standing.floorM + building.eavesM;
    for (int strip = 0; strip < strips; ++strip)
    {
        const double besideM = firstM + (strip + 0.5) * stripM;
        const std::vector<double> crossings = crossingsOf(building.rings, along, besideM);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        {
            const glm::dvec2 from = crossings[i] * along + besideM * across,
                             to = crossings[i + 1] * along + besideM * across;
            simulation::Obstacle part =
                simulation::pieceBetween(simulation::ObstacleKind::house, from, to, stripM);
            part.lowM = eavesM - kSlabM;
            part.highM = eavesM + roof.heightM(0.5 * (from + to));
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
