// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osg/MatrixTransform>

#include "scenery/nodes/EntityLamps.h"
#include "scenery/nodes/EntityShapes.h"
#include "simulation/player/EntityState.h"

namespace scenery
{

/// A generated entity in the scene: progressive parts that follow its motion, lamps, and a soft shadow where it touches
/// the ground. Frame: as OpenSCENARIO entities: origin on the ground below the rear axle, x forward, y left, z up;
/// metres. Needs the uniforms of an Atmosphere above it in the graph. Threads: setState() in the update phase.
class EntityNode
{
public:
    EntityNode(const models::EntityShape& shape, EntityShapes& shapes);

    /// Returns the node, which setState() places.
    osg::Node* node() const { return _placed.get(); }

    /// Places the entity, its wheels or legs, and lights its lamps.
    void setState(const simulation::EntityState& state, const models::LitLamps& lit);

    /// Returns the eye of the driver, rider or walker. Frame: the entity's.
    const glm::dvec3& eye() const { return _entity->model.eye; }

private:
    std::shared_ptr<const ProgressiveEntity> _entity;
    osg::ref_ptr<osg::MatrixTransform> _placed;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _parts;
    EntityLamps _lamps;
};

} // namespace scenery
