// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <osgPMObjects/ProgressiveShape>

#include "scenery/models/entities/EntityModel.h"
#include "scenery/nodes/ModelStates.h"

namespace scenery
{

/// A generated entity whose meshes are progressive.
struct ProgressiveEntity
{
    models::EntityModel model;
    std::vector<osg::ref_ptr<osgPMObjects::ProgressiveShape>> meshes; ///< by EntityModel::parts
};

/// Generates entities; equal shapes share one. Threads: one. Cost: 50 to 400 ms for a new shape, most of it
/// for simplification.
class EntityShapes
{
public:
    std::shared_ptr<const ProgressiveEntity> of(const models::EntityShape& shape);

private:
    std::map<models::EntityShape, std::shared_ptr<const ProgressiveEntity>> _made;
    ModelStates _states;
};

} // namespace scenery
