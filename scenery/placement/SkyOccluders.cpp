// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/SkyOccluders.h"

#include <cmath>
#include <utility>

#include "scenery/models/Catalogue.h"

namespace scenery
{

namespace
{

using models::Kind;

constexpr double kWallReflects = 0.25;
constexpr double kCrownOpaque = 0.8; ///< leaves let some light through, and there are gaps
constexpr double kCrownShare = 0.8;  ///< of the circle around a tree
constexpr double kVehicleOpaque = 0.95, kVehicleClearM = 0.2;
constexpr double kHouseM = 5.0;

bool isTree(Kind kind)
{
    return kind <= Kind::bush;
}

/// How high the lowest leaves of a tree are at scale 1.
double lowestLeavesM(Kind kind)
{
    if (kind == Kind::oak || kind == Kind::birch) return 2.2;
    return kind == Kind::poplar ? 1.0 : kind == Kind::spruce ? 0.5 : 0.1;
}

void addWalls(SkyOccluders& occluders, const Placement& placement, const Measures& measures)
{
    const glm::dvec2 low = measures.baseLow, high = measures.baseHigh;
    const glm::dvec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    const auto placed = [&](const glm::dvec2& corner)
    { return glm::dvec2(placement.position + placement.axes * glm::dvec3(placement.scale * corner, 0.0)); };
    for (int i = 0; i < 4; ++i)
        occluders.walls.push_back(
            {placed(corners[i]), placed(corners[(i + 1) % 4]), kHouseM * placement.scale});
}

void addOccluder(SkyOccluders& occluders, const Placement& placement, Kind kind, const Measures& measures)
{
    const double scale = placement.scale;
    const glm::dvec2 ahead(placement.axes[0]);
    if (isTree(kind))
    {
        const glm::dvec2 half(kCrownShare * measures.radiusM * scale);
        occluders.bodies.push_back(
            {glm::dvec2(placement.position), {1.0, 0.0}, half, lowestLeavesM(kind) * scale, kCrownOpaque});
        return;
    }
    if (kind < Kind::saloon) return addWalls(occluders, placement, measures);
    const glm::dvec2 middle = 0.5 * scale * (measures.baseLow + measures.baseHigh);
    const glm::dvec2 half = 0.5 * scale * (measures.baseHigh - measures.baseLow);
    occluders.bodies.push_back({glm::dvec2(placement.position + placement.axes * glm::dvec3(middle, 0.0)),
                                glm::normalize(ahead), half, kVehicleClearM * scale, kVehicleOpaque});
}

} // namespace

void SkyOccluders::add(SkyOccluders more)
{
    if (bodies.empty()) std::swap(bodies, more.bodies); // the most are not copied
    if (walls.empty()) std::swap(walls, more.walls);
    bodies.insert(bodies.end(), more.bodies.begin(), more.bodies.end());
    walls.insert(walls.end(), more.walls.begin(), more.walls.end());
}

double hiddenByWall(double awayM, double heightM)
{
    return (1.0 - kWallReflects) * 0.5 * (1.0 - awayM / std::hypot(awayM, std::max(heightM, 1e-6)));
}

double hiddenByDisc(double awayM, double radiusM, double heightM)
{
    const double h2 = heightM * heightM, r2 = radiusM * radiusM, a2 = awayM * awayM;
    const double sum = h2 + a2 + r2;
    return 0.5 * (1.0 - (sum - 2.0 * r2) / std::sqrt(std::max(sum * sum - 4.0 * r2 * a2, 1e-12)));
}

SkyOccluders occludersOf(const SceneryDescription& description, const PlacedScenery& placed,
                         const std::vector<Measures>& measures)
{
    SkyOccluders occluders;
    const std::vector<SceneryObject> objects = objectsOf(description);
    occluders.bodies.reserve(placed.placements.size());
    for (const Placement& placement : placed.placements)
        if (const auto kind = objects[placement.object].kind)
            addOccluder(occluders, placement, *kind, measures[placement.object]);
    return occluders;
}

} // namespace scenery
