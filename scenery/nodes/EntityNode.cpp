// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityNode.h"

#include <foundation/Angle.h>

#include <osgPMObjects/ProgressiveNode>

#include "scenery/nodes/ContactShadow.h"
#include "scenery/nodes/Pose.h"
#include "scenery/nodes/RotorDisc.h"

namespace scenery
{

namespace
{

osg::Matrixd osgMatrix(const glm::dmat4& matrix)
{
    return osg::Matrixd(&matrix[0][0]); // GLM's columns are OSG's rows
}

osg::ref_ptr<osg::MatrixTransform> makeMovable()
{
    const osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform;
    node->setDataVariance(osg::Object::DYNAMIC);
    return node;
}

std::optional<std::array<models::AircraftMotion::Leg, 3>> legsOf(const simulation::AircraftParts& parts)
{
    if (parts.wheelBottom == std::array<glm::dvec3, simulation::kGearLegs>{}) return std::nullopt; // not told
    std::array<models::AircraftMotion::Leg, 3> legs;
    for (std::size_t i = 0; i < legs.size(); ++i)
        legs[i] = {parts.wheelBottom[i], parts.strutM[i], foundation::radiansOf(parts.wheelTurnDeg[i])};
    return legs;
}

models::AircraftMotion motionOf(const simulation::AircraftParts& parts)
{
    using foundation::radiansOf;
    return {radiansOf(parts.elevatorDeg), radiansOf(parts.leftAileronDeg),  radiansOf(parts.rightAileronDeg),
            radiansOf(parts.rudderDeg),   radiansOf(parts.flapDeg),         radiansOf(parts.propellerTurnDeg),
            parts.propellerRadps,         radiansOf(parts.noseSteeringDeg), legsOf(parts)};
}

models::EntityMotion motionOf(const simulation::EntityState& state)
{
    models::EntityMotion motion{state.odometerM, state.speedMps, foundation::radiansOf(state.steeringDeg),
                                state.wheelTravelM};
    if (state.wheelTurnDeg)
    {
        motion.wheelTurnRad.emplace();
        for (std::size_t i = 0; i < state.wheelTurnDeg->size(); ++i)
            (*motion.wheelTurnRad)[i] = foundation::radiansOf((*state.wheelTurnDeg)[i]);
    }
    if (state.aircraft) motion.aircraft = motionOf(*state.aircraft);
    return motion;
}

} // namespace

EntityNode::EntityNode(const models::EntityShape& shape, EntityShapes& shapes)
    : _entity(shapes.of(shape)), _placed(makeMovable()), _lamps(_entity->model.lamps)
{
    for (const std::size_t mesh : _entity->model.parts)
    {
        const osg::ref_ptr<osg::MatrixTransform> part = makeMovable();
        if (const auto& names = _entity->model.names; _parts.size() < names.size())
            part->setName(names[_parts.size()]);
        part->addChild(new osgPMObjects::ProgressiveNode(_entity->meshes[mesh]));
        _parts.push_back(part);
        _placed->addChild(part);
    }
    if (_lamps.node()) _placed->addChild(_lamps.node());
    const models::EntityModel& model = _entity->model;
    for (const models::EntityRotor& rotor : model.rotors)
    {
        _discs.push_back(makeRotorDisc(rotor));
        _placed->addChild(_discs.back());
    }
    setState({}, {});
    if (model.shadowHalfLengthM <= 0.0) return;
    const auto single = [](double metres) { return static_cast<float>(metres); };
    _placed->addChild(makeContactShadow({single(model.shadowMiddleXM), 0.0F}, single(model.shadowHalfLengthM),
                                        single(model.shadowHalfWidthM)));
}

void EntityNode::setState(const simulation::EntityState& state, const models::LitLamps& lit)
{
    _placed->setMatrix(osgMatrix(worldFromModel(poseOf(state))));
    const models::EntityMotion motion = motionOf(state);
    _state = state;
    _pose = _entity->model.pose(motion);
    for (std::size_t i = 0; i < _parts.size(); ++i)
        _parts[i]->setMatrix(osgMatrix(_pose[i]));
    for (std::size_t i = 0; i < _discs.size(); ++i)
    {
        const models::EntityRotor& rotor = _entity->model.rotors[i];
        const bool isDisc = isBlurred(rotor.turns * motion.aircraft.rotorRadps);
        _discs[i]->setNodeMask(isDisc ? ~0U : 0U);
        _parts[rotor.blades]->setNodeMask(isDisc ? 0U : ~0U);
    }
    _lamps.light(lit);
}

void EntityNode::castShadow(const glm::dvec3& sun, const simulation::GroundProvider& ground)
{
    _shadow.show(_entity->model, _pose, _state, sun, ground);
}

} // namespace scenery
