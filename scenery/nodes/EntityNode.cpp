// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityNode.h"

#include <foundation/Angle.h>

#include <osgPMObjects/ProgressiveNode>

#include "scenery/nodes/ContactShadow.h"
#include "scenery/nodes/Pose.h"

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

models::EntityMotion motionOf(const simulation::EntityState& state)
{
    return {state.odometerM, state.speedMps, foundation::radiansOf(state.steeringDeg), state.wheelTravelM};
}

} // namespace

EntityNode::EntityNode(const models::EntityShape& shape, EntityShapes& shapes)
    : _entity(shapes.of(shape)), _placed(makeMovable()), _lamps(_entity->model.lamps)
{
    for (const std::size_t mesh : _entity->model.parts)
    {
        const osg::ref_ptr<osg::MatrixTransform> part = makeMovable();
        part->addChild(new osgPMObjects::ProgressiveNode(_entity->meshes[mesh]));
        _parts.push_back(part);
        _placed->addChild(part);
    }
    if (_lamps.node()) _placed->addChild(_lamps.node());
    const models::EntityModel& model = _entity->model;
    const auto single = [](double metres) { return static_cast<float>(metres); };
    _placed->addChild(makeContactShadow({single(model.shadowMiddleXM), 0.0F}, single(model.shadowHalfLengthM),
                                        single(model.shadowHalfWidthM)));
    setState({}, {});
}

void EntityNode::setState(const simulation::EntityState& state, const models::LitLamps& lit)
{
    _placed->setMatrix(osgMatrix(worldFromModel(poseOf(state))));
    const std::vector<glm::dmat4> pose = _entity->model.pose(motionOf(state));
    for (std::size_t i = 0; i < _parts.size(); ++i)
        _parts[i]->setMatrix(osgMatrix(pose[i]));
    _lamps.light(lit);
}

} // namespace scenery
