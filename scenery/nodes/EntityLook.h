// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "scenery/models/entities/EntityShape.h"
#include "scenery/models/vehicles/VehicleLook.h"
#include "simulation/scenario/Entity.h"

namespace scenery
{

/// What a scenario's object looks like.
struct EntityLook
{
    models::EntityShape shape;
    std::string note; ///< why the shape differs from the file's; empty: it does not
};

/// Chooses kind, size and colour. The kind follows the category and, where that leaves it open, words in the
/// names of the object, of its type and of its model (tractor, cone, wall, moose, glider, ferry …); the
/// colour follows a colour word there (`car_red`), else the object's name, and so does the body of a car
/// (saloon, hatchback, estate, sport utility vehicle), as far as its size leaves it open. The size is that of
/// the bounding box, or the usual one where the box cannot be that of the kind. Pure.
/// `vehicle`: the look that the object's `model3d` names, which tells the kind, the colours to choose from
/// and the usual size; null: none.
EntityLook entityLook(const simulation::ScenarioObject& object,
                      const std::shared_ptr<const models::VehicleLook>& vehicle = nullptr);

} // namespace scenery
