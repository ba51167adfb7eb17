// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/ObstacleBodies.h"

#include <algorithm>
#include <utility>

#include "simulation/vehicle/road/ObstaclePlace.h"

namespace simulation
{

namespace
{

constexpr int kIsObstacle = 0x0b57; ///< in the second index of a body of Bullet

std::unique_ptr<btCollisionShape> obstacleShape(const Obstacle& obstacle)
{
    const btVector3 halfM = obstacleHalf(obstacle);
    if (obstacle.isRound)
        return std::make_unique<btCylinderShapeZ>(btVector3(halfM.x(), halfM.x(), halfM.z()));
    return std::make_unique<btBoxShape>(halfM);
}

} // namespace

ObstacleBodies::~ObstacleBodies()
{
    for (const auto& [number, standing] : _standing)
        _world.removeCollisionObject(&standing->object);
}

std::optional<std::uint32_t> ObstacleBodies::numberOf(const btCollisionObject& object)
{
    if (object.getUserIndex2() != kIsObstacle) return std::nullopt;
    return static_cast<std::uint32_t>(object.getUserIndex());
}

void ObstacleBodies::stand(int body, const ObstacleMap& map, std::span<const std::uint32_t> numbers)
{
    std::vector<std::uint32_t>& wanted = _wanted[body];
    if (std::equal(wanted.begin(), wanted.end(), numbers.begin(), numbers.end())) return;
    wanted.assign(numbers.begin(), numbers.end());
    fit(map);
}

void ObstacleBodies::fit(const ObstacleMap& map)
{
    const auto isWanted = [&](std::uint32_t number)
    {
        return std::any_of(_wanted.begin(), _wanted.end(),
                           [&](const auto& wanted) {
                               return std::binary_search(wanted.second.begin(), wanted.second.end(), number);
                           });
    };
    for (auto standing = _standing.begin(); standing != _standing.end();)
    {
        if (isWanted(standing->first))
        {
            ++standing;
            continue;
        }
        _world.removeCollisionObject(&standing->second->object);
        standing = _standing.erase(standing);
    }
    for (const auto& [body, numbers] : _wanted)
        for (const std::uint32_t number : numbers)
        {
            const auto [standing, isNew] = _standing.try_emplace(number);
            if (!isNew) continue;
            const Obstacle& obstacle = map.at(number);
            standing->second = std::make_unique<Standing>();
            standing->second->shape = obstacleShape(obstacle);
            btCollisionObject& object = standing->second->object;
            object.setCollisionShape(standing->second->shape.get());
            object.setWorldTransform(obstaclePlace(obstacle));
            object.setFriction(factsOf(obstacle.kind).friction);
            object.setRestitution(1.0); // times that of the hull
            object.setUserIndex(static_cast<int>(number));
            object.setUserIndex2(kIsObstacle);
            _world.addCollisionObject(&object, btBroadphaseProxy::StaticFilter,
                                      btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
        }
}

} // namespace simulation
