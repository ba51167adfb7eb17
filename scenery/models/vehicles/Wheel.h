// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// Adds a closed wheel, 20 sides, 360 triangles: a tyre with shoulders, and a dished rim whose spokes are in
/// the texture. `outwards`: +1 looks left, -1 right. Precondition: a part with the texture `wheel` has begun.
struct Wheel
{
    glm::dvec3 hub{0.0};
    double radiusM = 0.32, widthM = 0.2, outwards = 1.0;
};
void addWheel(ModelBuilder& builder, const Wheel& wheel);

} // namespace scenery::models
