// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/PlacedObstacles.h"

#include <algorithm>

#include "scenery/models/trees/PlantObstacle.h"

namespace scenery
{

namespace
{

using models::Kind;
using simulation::Obstacle;
using simulation::ObstacleKind;

constexpr double kBaseDepthM = 1.0;

/// The box of an object's base.
Obstacle baseOf(const Placement& placement, const Measures& measures)
{
    const glm::dvec2 middle = 0.5 * placement.scale * (measures.baseLow + measures.baseHigh);
    Obstacle base;
    base.middle = glm::dvec2(placement.position + placement.axes * glm::dvec3(middle, 0.0));
    const glm::dvec2 ahead(placement.axes[0]);
    base.along = ahead / std::max(1e-9, glm::length(ahead));
    base.halfM = 0.5 * placement.scale * (measures.baseHigh - measures.baseLow);
    base.lowM = placement.position.z - kBaseDepthM;
    base.highM = placement.position.z + 2.0 * std::max(base.halfM.x, base.halfM.y);
    return base;
}

} // namespace

void addObstacles(const SceneryDescription& description, const PlacedScenery& placed,
                  const std::vector<Measures>& measures, simulation::ObstacleList& obstacles)
{
    const std::vector<SceneryObject> objects = objectsOf(description);
    for (const Placement& placement : placed.placements)
    {
        const std::optional<Kind> kind = objects[placement.object].kind;
        if (kind && *kind <= Kind::bush)
        {
            obstacles.add(models::plantObstacle(*kind, placement.position, placement.scale),
                          models::factsOf(*kind).name);
            continue;
        }
        Obstacle base = baseOf(placement, measures[placement.object]);
        if (kind)
        {
            base.kind = *kind < Kind::saloon ? ObstacleKind::house : ObstacleKind::vehicle;
            base.highM = placement.position.z + models::meanHeightM(*kind) * placement.scale;
        }
        obstacles.add(base, kind ? models::factsOf(*kind).name : std::string_view("object"));
    }
}

} // namespace scenery
