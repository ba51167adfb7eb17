// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/BodyWorld.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <btBulletDynamicsCommon.h>

#include "simulation/vehicle/road/GroundPatch.h"
#include "simulation/vehicle/road/MovingBodies.h"
#include "simulation/vehicle/road/ObstacleBodies.h"

namespace simulation
{

namespace
{

btVector3 bulletOf(const glm::dvec3& vector)
{
    return {vector.x, vector.y, vector.z};
}

glm::dvec3 vectorOf(const btVector3& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

} // namespace

/// A body with the shapes that it is made of.
struct Solid
{
    std::vector<std::unique_ptr<btBoxShape>> boxes;
    btCompoundShape shape;
    std::unique_ptr<btRigidBody> body;
    SolidHit hit;
};

struct BodyWorld::Parts
{
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    GroundPatches patches;
    btCollisionObject ground;
    bool hasGround = false;
    ObstacleBodies obstacles{world};
    MovingBodies movers{world};
    std::vector<std::unique_ptr<Solid>> solids;

    Solid& at(int body) { return *solids[static_cast<std::size_t>(body)]; }

    void readHits();
};

BodyWorld::BodyWorld() : _parts(std::make_unique<Parts>())
{
    _parts->world.setGravity({0.0, 0.0, 0.0});
    _parts->ground.setCollisionShape(&_parts->patches);
    _parts->ground.setFriction(1.0);
    _parts->ground.setRestitution(0.0);
    _parts->world.getSolverInfo().m_splitImpulse = 1; // depth is mended without making speed
    _parts->world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0.0;
}

BodyWorld::~BodyWorld()
{
    for (const auto& solid : _parts->solids)
        _parts->world.removeRigidBody(solid->body.get());
    if (_parts->hasGround) _parts->world.removeCollisionObject(&_parts->ground);
}

int BodyWorld::add(const RoadMassProperties& mass, const HullData& hull)
{
    auto solid = std::make_unique<Solid>();
    for (const HullBox& box : hull.boxes)
    {
        solid->boxes.push_back(std::make_unique<btBoxShape>(bulletOf(0.5 * box.sizeM)));
        solid->shape.addChildShape(
            btTransform(btQuaternion::getIdentity(), bulletOf(box.place - mass.centre)),
            solid->boxes.back().get());
    }
    btRigidBody::btRigidBodyConstructionInfo info(mass.massKg, nullptr, &solid->shape,
                                                  bulletOf(mass.inertiaKgM2));
    info.m_friction = hull.friction;
    info.m_restitution = 0.1;
    solid->body = std::make_unique<btRigidBody>(info);
    solid->body->setActivationState(DISABLE_DEACTIVATION);
    _parts->world.addRigidBody(solid->body.get());
    _parts->solids.push_back(std::move(solid));
    return static_cast<int>(_parts->solids.size()) - 1;
}

void BodyWorld::place(int body, const SolidMotion& motion)
{
    btRigidBody& solid = *_parts->at(body).body;
    const glm::dquat& q = motion.bodyToScene;
    const btTransform transform(btQuaternion(q.x, q.y, q.z, q.w), bulletOf(motion.position));
    solid.setWorldTransform(transform);
    solid.setInterpolationWorldTransform(transform);
    solid.setLinearVelocity(bulletOf(motion.velocity));
    solid.setAngularVelocity(bulletOf(motion.rates));
    solid.setInterpolationLinearVelocity(solid.getLinearVelocity());
    solid.setInterpolationAngularVelocity(solid.getAngularVelocity());
    solid.updateInertiaTensor();
    solid.clearForces();
}

SolidMotion BodyWorld::motion(int body) const
{
    const btRigidBody& solid = *_parts->at(body).body;
    const btQuaternion q = solid.getWorldTransform().getRotation();
    return {vectorOf(solid.getCenterOfMassPosition()),
            {q.w(), q.x(), q.y(), q.z()},
            vectorOf(solid.getLinearVelocity()),
            vectorOf(solid.getAngularVelocity())};
}

void BodyWorld::setGravity(int body, const glm::dvec3& gravity)
{
    _parts->at(body).body->setGravity(bulletOf(gravity));
}

void BodyWorld::push(int body, const glm::dvec3& force, const glm::dvec3& arm)
{
    _parts->at(body).body->applyForce(bulletOf(force), bulletOf(arm));
}

void BodyWorld::layGround(int body, const Ground& ground, double reachM)
{
    _parts->patches.lay(body, ground, vectorOf(_parts->at(body).body->getCenterOfMassPosition()), reachM);
    if (std::exchange(_parts->hasGround, true)) return;
    _parts->world.addCollisionObject(&_parts->ground, btBroadphaseProxy::StaticFilter,
                                     btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
}

void BodyWorld::liftGround(int body)
{
    _parts->patches.lift(body);
    if (!_parts->hasGround || !_parts->patches.isEmpty()) return;
    _parts->hasGround = false;
    _parts->world.removeCollisionObject(&_parts->ground);
}

void BodyWorld::Parts::readHits()
{
    for (const auto& solid : solids)
        solid->hit = {};
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i)
    {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() == 0) continue;
        double impulse = 0.0;
        bool touches = false;
        const btManifoldPoint* hardest = &manifold.getContactPoint(0);
        for (int c = 0; c < manifold.getNumContacts(); ++c)
        {
            const btManifoldPoint& point = manifold.getContactPoint(c);
            impulse += point.getAppliedImpulse();
            touches = touches || point.getDistance() <= 0.0;
            if (point.getAppliedImpulse() > hardest->getAppliedImpulse()) hardest = &point;
        }
        const btCollisionObject* const both[] = {manifold.getBody0(), manifold.getBody1()};
        for (const auto& solid : solids)
        {
            if (solid->body.get() != both[0] && solid->body.get() != both[1]) continue;
            solid->hit.touches = solid->hit.touches || touches;
            // The change of speed that the contact made.
            const double change = impulse * solid->body->getInvMass();
            solid->hit.closingMps = std::max(solid->hit.closingMps, change);
            for (const btCollisionObject* other : both)
                if (const auto number = ObstacleBodies::numberOf(*other);
                    number && change > solid->hit.obstacleMps)
                {
                    solid->hit.obstacle = number;
                    solid->hit.obstacleMps = change;
                    solid->hit.place = vectorOf(hardest->getPositionWorldOnA());
                }
                else if (const auto mover = MovingBodies::numberOf(*other))
                {
                    if (touches) solid->hit.movers.push_back(*mover);
                    if (change <= solid->hit.moverMps) continue;
                    solid->hit.mover = mover;
                    solid->hit.moverMps = change;
                    solid->hit.moverPlace = vectorOf(hardest->getPositionWorldOnA());
                }
        }
    }
}

void BodyWorld::stand(int body, const ObstacleMap& map, std::span<const std::uint32_t> numbers)
{
    _parts->obstacles.stand(body, map, numbers);
}

void BodyWorld::accompany(std::span<const MovingObstacle> movers)
{
    _parts->movers.place(movers);
}

void BodyWorld::strike(int body, const glm::dvec3& impulse, const glm::dvec3& arm)
{
    _parts->at(body).body->applyImpulse(bulletOf(impulse), bulletOf(arm));
}

double BodyWorld::inverseMassAt(int body, const glm::dvec3& arm, const glm::dvec3& direction) const
{
    const btRigidBody& solid = *_parts->at(body).body;
    return solid.computeImpulseDenominator(solid.getCenterOfMassPosition() + bulletOf(arm),
                                           bulletOf(direction));
}

void BodyWorld::step(double stepS)
{
    _parts->movers.advance(stepS);
    _parts->world.stepSimulation(stepS, 0);
    _parts->readHits();
}

SolidHit BodyWorld::hit(int body) const
{
    return _parts->at(body).hit;
}

} // namespace simulation
