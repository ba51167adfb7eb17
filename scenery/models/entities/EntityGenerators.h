// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/entities/EntityModel.h"

/// The generators by kind, called by makeEntityModel() with sizes above 0.
namespace scenery::models
{

EntityModel makeRoadVehicle(const EntityShape& shape); ///< car, van, bus
EntityModel makeLorry(const EntityShape& shape);       ///< lorry, tractor, trailers
EntityModel makeMotorbike(const EntityShape& shape);
EntityModel makeBicycle(const EntityShape& shape);
EntityModel makePedestrian(const EntityShape& shape);
EntityModel makeWheelchair(const EntityShape& shape);
EntityModel makeAnimal(const EntityShape& shape);
EntityModel makeLightAircraft(const EntityShape& shape);
EntityModel makeLowWingAircraft(const EntityShape& shape); ///< of one size
EntityModel makeGlider(const EntityShape& shape);
EntityModel makeAirliner(const EntityShape& shape);
EntityModel makeHelicopter(const EntityShape& shape);
EntityModel makeShip(const EntityShape& shape);
EntityModel makeThing(const EntityShape& shape); ///< cone, barrier, pole, box

} // namespace scenery::models
