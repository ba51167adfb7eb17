// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace scenery
{

enum class Stance : std::uint8_t
{
    upright, ///< trees, houses: its foundation takes up slopes
    tilted,  ///< vehicles: wheels stand on the ground
};

/// What placement has to know of an object, at scale 1.
/// Frame: the object's: x forward, y left, z up, the ground at 0. Units: metres.
struct Measures
{
    double radiusM = 0.0;                   ///< of the circle about the z axis that all of it stands over
    double foundationM = 0.0;               ///< how far it reaches into the ground
    glm::dvec2 baseLow{0.0}, baseHigh{0.0}; ///< the rectangle of what is near the ground
    Stance stance = Stance::upright;
    bool isCrowned = false; ///< wide above, narrow at the ground: may grow into its like
};

/// Of a mesh that stands on z = 0. What is at most `nearGroundM` above its lowest ground counts as its base.
Measures measuresOf(const osgPMObjects::core::Mesh& mesh, double foundationM, Stance stance,
                    double nearGroundM = 0.4);

} // namespace scenery
