// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityShapes.h"

#include "scenery/models/looks/VehicleLookFile.h"
#include "scenery/nodes/ProgressiveModel.h"

namespace scenery
{

std::shared_ptr<const ProgressiveEntity> EntityShapes::of(const models::EntityShape& shape)
{
    std::shared_ptr<const ProgressiveEntity>& made = _made[shape];
    if (made) return made;
    const auto entity = std::make_shared<ProgressiveEntity>();
    entity->model = models::makeEntityModel(shape);
    for (const models::Model& mesh : entity->model.meshes)
        entity->meshes.push_back(
            new osgPMObjects::ProgressiveShape(progressiveOf(mesh.mesh), _states.statesOf(mesh)));
    made = entity;
    return made;
}

foundation::Result<std::shared_ptr<const models::VehicleLook>>
EntityShapes::lookIn(const std::filesystem::path& file)
{
    std::shared_ptr<const models::VehicleLook>& look = _looks[file.lexically_normal()];
    if (look) return look;
    auto read = models::readVehicleLook(file);
    if (!read) return read.error();
    look = std::make_shared<const models::VehicleLook>(*std::move(read));
    return look;
}

} // namespace scenery
