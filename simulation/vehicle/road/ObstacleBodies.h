// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <btBulletDynamicsCommon.h>

#include "simulation/contact/ObstacleMap.h"

namespace simulation
{

/// The obstacles near bodies as fixed bodies of a world of Bullet. They come and go in the order of their
/// numbers: the same calls give the same bytes.
class ObstacleBodies
{
public:
    explicit ObstacleBodies(btDiscreteDynamicsWorld& world) : _world(world) {}
    ~ObstacleBodies();
    ObstacleBodies(const ObstacleBodies&) = delete;
    ObstacleBodies& operator=(const ObstacleBodies&) = delete;

    /// Lets these things of a map, by their numbers in ascending order, stand around a body. All bodies of a
    /// world have one map.
    void stand(int body, const ObstacleMap& map, std::span<const std::uint32_t> numbers);

    /// The number of the thing that a body of Bullet stands for.
    static std::optional<std::uint32_t> numberOf(const btCollisionObject& object);

private:
    struct Standing
    {
        std::unique_ptr<btCollisionShape> shape;
        btCollisionObject object;
    };

    void fit(const ObstacleMap& map);

    btDiscreteDynamicsWorld& _world;
    std::map<int, std::vector<std::uint32_t>> _wanted; ///< by body
    std::map<std::uint32_t, std::unique_ptr<Standing>> _standing;
};

} // namespace simulation
