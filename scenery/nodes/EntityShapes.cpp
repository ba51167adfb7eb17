// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityShapes.h"

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

} // namespace scenery
