// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/BuildingObstacles.h"

namespace scenery
{

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
                obstacles.add(wall, building.openings == Openings::hangar ? "hangar" : "building");
            }
    }
}

} // namespace scenery
