// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/StructureObstacles.h"

#include <algorithm>
#include <cmath>

#include "scenery/structures/PowerLine.h"

namespace scenery
{

namespace
{

using simulation::Obstacle;
using simulation::ObstacleKind;

constexpr double kPieceStepM = 4.0, kLineDepthM = 0.4;
constexpr double kFenceM = 0.1, kPoleRadiusM = 0.15, kLegRadiusM = 0.12, kTurbineRadiusM = 2.0;
constexpr double kLegShare = 0.075; ///< of a pylon's height: from its middle to its legs
constexpr double kLegM = 6.0;       ///< of the legs that may be hit

/// A line as pieces on the ground: each from the lower of its ends to above the higher one.
void addLineObstacles(const Structure& structure, ObstacleKind kind, double widthM,
                      const foundation::HeightInPlan& ground, simulation::ObstacleList& obstacles)
{
    for (std::size_t i = 0; i + 1 < structure.line.size(); ++i)
    {
        const glm::dvec2 from = structure.line[i], to = structure.line[i + 1];
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / kPieceStepM)));
        for (int step = 0; step < steps; ++step)
        {
            const glm::dvec2 a = glm::mix(from, to, static_cast<double>(step) / steps),
                             b = glm::mix(from, to, static_cast<double>(step + 1) / steps);
            const auto low = ground(a), high = ground(b);
            if (!low || !high) continue;
            Obstacle piece = simulation::pieceBetween(kind, a, b, widthM);
            piece.lowM = std::min(*low, *high) - kLineDepthM;
            piece.highM = std::max(*low, *high) + structure.heightM;
            obstacles.add(piece);
        }
    }
}

void addRoundObstacle(const glm::dvec3& foot, double radiusM, double heightM, ObstacleKind kind,
                      const char* name, simulation::ObstacleList& obstacles)
{
    Obstacle body;
    body.kind = kind;
    body.isRound = true;
    body.middle = glm::dvec2(foot);
    body.halfM = glm::dvec2(radiusM);
    body.lowM = foot.z - 1.0;
    body.highM = foot.z + heightM;
    obstacles.add(body, name);
}

void addSupportObstacles(const Structure& line, const foundation::HeightInPlan& ground,
                         simulation::ObstacleList& obstacles)
{
    for (const Support& support : supportsOf(line, ground))
    {
        if (line.kind == StructureKind::poleLine)
        {
            addRoundObstacle(support.foot, kPoleRadiusM, support.heightM, ObstacleKind::mast, "pole",
                             obstacles);
            continue;
        }
        const glm::dvec2 left(-support.along.y, support.along.x);
        const double asideM = kLegShare * support.heightM;
        for (const double x : {-asideM, asideM})
            for (const double y : {-asideM, asideM})
                addRoundObstacle(support.foot + glm::dvec3(x * support.along + y * left, 0.0), kLegRadiusM,
                                 kLegM, ObstacleKind::mast, "pylon", obstacles);
    }
}

} // namespace

void addObstacles(const std::vector<Structure>& structures, const foundation::HeightInPlan& ground,
                  simulation::ObstacleList& obstacles)
{
    for (const Structure& structure : structures)
        switch (structure.kind)
        {
        case StructureKind::wall:
            addLineObstacles(structure, ObstacleKind::wall, structure.widthM, ground, obstacles);
            break;
        case StructureKind::fence:
            addLineObstacles(structure, ObstacleKind::fence, kFenceM, ground, obstacles);
            break;
        case StructureKind::powerLine:
        case StructureKind::poleLine:
            addSupportObstacles(structure, ground, obstacles);
            break;
        case StructureKind::windTurbine:
            if (!structure.line.empty())
                if (const auto height = ground(structure.line.front()))
                    addRoundObstacle({structure.line.front(), *height}, kTurbineRadiusM, structure.heightM,
                                     ObstacleKind::pillar, "wind turbine", obstacles);
            break;
        default:
            break;
        }
}

} // namespace scenery
