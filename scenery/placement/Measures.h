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

/// The sizes of an object that placement needs, at scale 1.
/// Frame: the object's: x forward, y left, z up, the ground at 0. Units: metres.
struct Measures
{
    double radiusM = 0.0;                   ///< of the circle about the z axis that contains it
    double foundationM = 0.0;               ///< how deep it reaches into the ground
    glm::dvec2 baseLow{0.0}, baseHigh{0.0}; ///< the rectangle of its parts near the ground
    Stance stance = Stance::upright;
    bool isCrowned = false; ///< wide above and narrow at the ground: crowns may overlap
};

/// Measures a mesh that stands on z = 0. Its base are the parts at most `nearGroundM` above its lowest
/// ground.
Measures measuresOf(const osgPMObjects::core::Mesh& mesh, double foundationM, Stance stance,
                    double nearGroundM = 0.4);

} // namespace scenery
