// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/MovingBodies.h"

#include "simulation/vehicle/road/ObstaclePlace.h"

namespace simulation
{

namespace
{

constexpr int kIsMover = 0x0b58; ///< in the second index of a body of Bullet

} // namespace

MovingBodies::~MovingBodies()
{
    for (const auto& [number, mover] : _movers)
        _world.removeRigidBody(mover.body.get());
}

std::optional<int> MovingBodies::numberOf(const btCollisionObject& object)
{
    if (object.getUserIndex2() != kIsMover) return std::nullopt;
    return object.getUserIndex();
}

void MovingBodies::make(const MovingObstacle& thing, Mover& mover)
{
    if (mover.body) _world.removeRigidBody(mover.body.get());
    mover.halfM = obstacleHalf(thing.box);
    mover.shape = std::make_unique<btBoxShape>(mover.halfM);
    mover.body = std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(0.0, nullptr, mover.shape.get()));
    mover.body->setCollisionFlags(mover.body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    mover.body->setActivationState(DISABLE_DEACTIVATION);
    mover.body->setFriction(factsOf(thing.box.kind).friction);
    mover.body->setRestitution(1.0); // times that of the hull
    mover.body->setUserIndex(thing.number);
    mover.body->setUserIndex2(kIsMover);
    mover.body->setWorldTransform(obstaclePlace(thing.box));
    _world.addRigidBody(mover.body.get(), btBroadphaseProxy::KinematicFilter,
                        btBroadphaseProxy::AllFilter ^
                            (btBroadphaseProxy::StaticFilter | btBroadphaseProxy::KinematicFilter));
}

void MovingBodies::place(std::span<const MovingObstacle> movers)
{
    for (auto& [number, mover] : _movers)
        mover.isThere = false;
    for (const MovingObstacle& thing : movers)
    {
        Mover& mover = _movers[thing.number];
        if (!mover.body || mover.halfM != obstacleHalf(thing.box)) make(thing, mover);
        mover.isThere = true;
        mover.velocity = {thing.velocity.x, thing.velocity.y, 0.0};
        // Both the same: what it is put back by is no speed.
        mover.body->setWorldTransform(obstaclePlace(thing.box));
        mover.body->setInterpolationWorldTransform(mover.body->getWorldTransform());
    }
    std::erase_if(_movers,
                  [this](const auto& one)
                  {
                      if (!one.second.isThere) _world.removeRigidBody(one.second.body.get());
                      return !one.second.isThere;
                  });
}

void MovingBodies::advance(double stepS)
{
    for (auto& [number, mover] : _movers)
    {
        btTransform place = mover.body->getWorldTransform();
        mover.body->setInterpolationWorldTransform(place);
        place.setOrigin(place.getOrigin() + stepS * mover.velocity);
        mover.body->setWorldTransform(place);
    }
}

} // namespace simulation
