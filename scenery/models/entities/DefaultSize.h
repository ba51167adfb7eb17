// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/entities/EntityShape.h"

namespace scenery::models
{

/// Returns whether a box of this size can be that of the kind: a bus as low as a car cannot.
bool isPlausible(const EntityShape& shape);

/// Gives a shape the size and the axles that are usual for its kind. Kind and colour stay. Sources: the
/// dimensions of directive 96/53/EC for lorries, trailers and buses, otherwise of common makes.
void setDefaultSize(EntityShape& shape);

/// Adds the usual axles to a vehicle that has none, and makes wheels small enough for the height of the body.
void keepWheelsInside(EntityShape& shape);

} // namespace scenery::models
