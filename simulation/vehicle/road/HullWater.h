// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "simulation/vehicle/Hull.h"
#include "simulation/vehicle/road/BodyWorld.h"

namespace simulation
{

/// Water around a hull.
struct HullWater
{
    double levelM = 0.0;   ///< z of its surface
    double airShare = 1.0; ///< of the hull's volume that it has not filled
    /// drag over speed that one point bears at most, so that none is turned round
    double mostNsPerM = 0.0;
    glm::dvec3 gravityMps2{0.0};
};

/// Buoyancy and drag of a hull on a quarter of each of its boxes. `centre`: of mass, in the hull's frame.
/// `press`: takes a force and where it acts, from the centre of mass; scene's axes.
/// Source: Archimedes; drag of a plate, Hoerner, *Fluid-Dynamic Drag*, 1965, chapter 3 (about 1.1 of the
/// dynamic pressure across it).
void pressByWater(const HullData& hull, const glm::dvec3& centre, const SolidMotion& motion,
                  const HullWater& water,
                  const std::function<void(const glm::dvec3& force, const glm::dvec3& arm)>& press);

} // namespace simulation
