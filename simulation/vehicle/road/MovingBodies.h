// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>

#include <btBulletDynamicsCommon.h>

#include "simulation/contact/MovingObstacle.h"

namespace simulation
{

/// Things that move by themselves as kinematic bodies of a world of Bullet: what meets them is pushed, they
/// are not. They come and go in the order of their numbers: the same calls give the same bytes.
class MovingBodies
{
public:
    explicit MovingBodies(btDiscreteDynamicsWorld& world) : _world(world) {}
    ~MovingBodies();
    MovingBodies(const MovingBodies&) = delete;
    MovingBodies& operator=(const MovingBodies&) = delete;

    /// From now on these are there, each where it is now; all others go.
    void place(std::span<const MovingObstacle> movers);

    /// Moves them on for the step that follows. Units: seconds.
    void advance(double stepS);

    /// The number of the thing that a body of Bullet stands for.
    static std::optional<int> numberOf(const btCollisionObject& object);

private:
    struct Mover
    {
        std::unique_ptr<btBoxShape> shape;
        std::unique_ptr<btRigidBody> body;
        btVector3 halfM, velocity;
        bool isThere = true;
    };

    void make(const MovingObstacle& thing, Mover& mover);

    btDiscreteDynamicsWorld& _world;
    std::map<int, Mover> _movers;
};

} // namespace simulation
