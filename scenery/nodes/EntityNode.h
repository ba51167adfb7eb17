// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osg/MatrixTransform>

#include "scenery/nodes/EntityLamps.h"
#include "scenery/nodes/EntityShapes.h"
#include "scenery/nodes/SunShadow.h"
#include "simulation/state/EntityState.h"

namespace scenery
{

/// A generated entity in the scene: progressive parts that follow its motion, lamps, discs of rotors, a soft
/// shadow where it touches the ground, and the shadow that the sun makes of it. Frame: as OpenSCENARIO
/// entities: origin on the ground below the rear axle, x forward, y left, z up; metres. Needs the uniforms of
/// an Atmosphere above it in the graph. Threads: setState() in the update phase.
class EntityNode
{
public:
    EntityNode(const models::EntityShape& shape, EntityShapes& shapes);

    /// Returns the node, which setState() places.
    osg::Node* node() const { return _placed.get(); }

    /// Places the entity, its wheels, legs or surfaces, and lights its lamps.
    void setState(const simulation::EntityState& state, const models::LitLamps& lit);

    /// Casts its shadow for the last state. `sun`: towards it, unit vector.
    void castShadow(const glm::dvec3& sun, const simulation::GroundProvider& ground);

    /// Returns the node of the shadow, which stands beside node() in the scene.
    osg::Node* shadow() const { return _shadow.node(); }

    /// Returns the eye of the driver, rider or walker. Frame: the entity's.
    const glm::dvec3& eye() const { return _entity->model.eye; }

    /// Frame: the entity's.
    const std::vector<models::EntityLamp>& lamps() const { return _entity->model.lamps; }

private:
    std::shared_ptr<const ProgressiveEntity> _entity;
    osg::ref_ptr<osg::MatrixTransform> _placed;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _parts;
    std::vector<osg::ref_ptr<osg::Node>> _discs; ///< by EntityModel::rotors
    EntityLamps _lamps;
    SunShadow _shadow;
    simulation::EntityState _state;
    std::vector<glm::dmat4> _pose;
};

} // namespace scenery
