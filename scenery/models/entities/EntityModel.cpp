// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/EntityModel.h"

#include <algorithm>

#include "scenery/models/entities/DefaultSize.h"
#include "scenery/models/entities/EntityGenerators.h"

namespace scenery::models
{

namespace
{

EntityModel generate(const EntityShape& shape)
{
    switch (shape.kind)
    {
    case EntityKind::car:
    case EntityKind::van:
    case EntityKind::bus:
        return makeRoadVehicle(shape);
    case EntityKind::lorry:
    case EntityKind::tractor:
    case EntityKind::semitrailer:
    case EntityKind::trailer:
        return makeLorry(shape);
    case EntityKind::motorbike:
        return makeMotorbike(shape);
    case EntityKind::bicycle:
        return makeBicycle(shape);
    case EntityKind::pedestrian:
        return makePedestrian(shape);
    case EntityKind::wheelchair:
        return makeWheelchair(shape);
    case EntityKind::horse:
    case EntityKind::cow:
    case EntityKind::sheep:
    case EntityKind::deer:
    case EntityKind::dog:
        return makeAnimal(shape);
    case EntityKind::lightAircraft:
        return makeLightAircraft(shape);
    case EntityKind::glider:
        return makeGlider(shape);
    case EntityKind::airliner:
        return makeAirliner(shape);
    case EntityKind::helicopter:
        return makeHelicopter(shape);
    case EntityKind::ship:
        return makeShip(shape);
    default:
        return makeThing(shape);
    }
}

} // namespace

EntityModel makeEntityModel(EntityShape shape)
{
    keepWheelsInside(shape);
    EntityModel model = generate(shape);
    if (shape.kind == EntityKind::pedestrian) return model;
    if (isAircraft(shape.kind) || shape.kind == EntityKind::ship)
    {
        model.shadowHalfLengthM = 0.0; // it stands on legs, or on nothing
        return model;
    }
    model.shadowMiddleXM = shape.middleXM;
    model.shadowHalfLengthM = 0.5 * shape.lengthM;
    model.shadowHalfWidthM = 0.5 * shape.widthM;
    return model;
}

} // namespace scenery::models
