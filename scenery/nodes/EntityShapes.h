// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include <foundation/Result.h>

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

/// Generates entities; equal shapes share one, and so do entities that name the same file of a look. Threads:
/// one. Cost: 50 to 400 ms for a new shape, most of it for simplification.
class EntityShapes
{
public:
    std::shared_ptr<const ProgressiveEntity> of(const models::EntityShape& shape);

    /// Returns the look in a file, the same for all that name it. Errors: those of readVehicleLook().
    foundation::Result<std::shared_ptr<const models::VehicleLook>> lookIn(const std::filesystem::path& file);

private:
    std::map<std::filesystem::path, std::shared_ptr<const models::VehicleLook>> _looks;
    std::map<models::EntityShape, std::shared_ptr<const ProgressiveEntity>> _made;
    ModelStates _states;
};

} // namespace scenery
