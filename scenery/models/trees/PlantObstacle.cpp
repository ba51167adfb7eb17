// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/trees/PlantObstacle.h"

#include "scenery/models/trees/TreeForm.h"

namespace scenery::models
{

namespace
{

constexpr double kPlantFootM = 1.0;
constexpr double kBushShare = 0.5; ///< of the circle around a bush: what holds

} // namespace

simulation::Obstacle plantObstacle(Kind kind, const glm::dvec3& foot, double scale)
{
    static_assert(static_cast<int>(Kind::bush) == static_cast<int>(TreeKind::bush));
    const bool isBush = kind == Kind::bush;
    const double heightM = meanHeightM(kind) * scale;
    simulation::Obstacle plant;
    plant.kind = isBush ? simulation::ObstacleKind::hedge : simulation::ObstacleKind::tree;
    plant.isRound = true;
    plant.middle = glm::dvec2(foot);
    plant.halfM = glm::dvec2(isBush ? kBushShare * factsOf(kind).mostRadiusM * scale
                                    : treeForm(static_cast<TreeKind>(kind)).trunkRadius * heightM);
    plant.lowM = foot.z - kPlantFootM;
    plant.highM = foot.z + heightM;
    return plant;
}

} // namespace scenery::models
