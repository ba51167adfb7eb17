// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// A wheel: tyre with shoulders, a dished rim with its spokes in the picture. Closed, 20 sides, 360 triangles.
/// `outwards`: +1 looks to the left, -1 to the right. Begin its part before, with the picture `wheel`.
struct Wheel
{
    glm::dvec3 hub{0.0};
    double radiusM = 0.32, widthM = 0.2, outwards = 1.0;
};
void addWheel(ModelBuilder& builder, const Wheel& wheel);

} // namespace scenery::models
