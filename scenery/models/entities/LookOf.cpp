// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/LookOf.h"

#include "scenery/models/looks/BuiltInLooks.h"

namespace scenery::models
{

std::shared_ptr<const VehicleLook> lookOf(const EntityShape& shape)
{
    if (shape.look) return shape.look;
    if (shape.kind == EntityKind::van) return builtInLook("van");
    if (shape.kind == EntityKind::bus) return builtInLook("bus");
    return builtInLook(shape.body == CarBody::saloon ? "saloon" : "estate");
}

} // namespace scenery::models
