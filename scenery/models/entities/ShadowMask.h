// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "scenery/models/entities/EntityModel.h"

namespace scenery::models
{

/// The shadow of a body on a plane: how much of the sun it hides, by cells of a square grid.
/// Frame: the plane's: u and v in it, their origin below or at the body's.
struct ShadowMask
{
    static constexpr int kCells = 96; ///< each way

    glm::dvec2 low{0.0}, high{0.0};  ///< of the grid; metres
    std::vector<std::uint8_t> cover; ///< row by row from low; 255: all of the sun is hidden

    /// The share of the sun that is hidden at (u, v), of the nearest cell; 0 outside.
    double at(const glm::dvec2& place) const;
};

/// Where the sun stands and how the body lies, seen from the plane.
struct ShadowView
{
    glm::dmat3 planeFromBody{1.0};
    glm::dvec3 sun{0.0, 0.0, 1.0}; ///< towards it, unit vector in the plane's frame; z above 0
    double heightM = 0.0;          ///< of the body's origin above the plane; it makes the edge softer
};

/// Casts the shadow of a model with its parts at `pose`. The middle of the grid is where the body's origin
/// casts its shadow, moved by as much as the body is aside. The edge is blurred as the width of the sun, half
/// a degree, makes it. Cost: about 0.3 ms.
ShadowMask castShadow(const EntityModel& model, const std::vector<glm::dmat4>& pose, const ShadowView& view);

} // namespace scenery::models
