// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "scenery/models/mesh/ModelBuilder.h"
#include "scenery/models/roads/RoadModel.h"

namespace scenery::models
{

/// Adds a flat closed plate across the road that looks towards -x. `middle`: of its face.
struct Plate
{
    glm::dvec3 middle{0.0};
    double widthM = 0.6, heightM = 0.6, thicknessM = 0.02;
    RoadModel::Shape shape = RoadModel::Shape::round;
    SignCell front, back;
};
void addPlate(ModelBuilder& builder, const Plate& plate);

} // namespace scenery::models
