// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// The cells of the texture houseDetails, 4 × 4 from the lower left: windows, doors and fittings of walls and
/// roofs.
enum class Detail : std::uint8_t
{
    window,     ///< two sashes
    barsWindow, ///< with glazing bars
    hallWindow, ///< a band of panes
    shopFront,
    door,
    glassDoor,
    gate, ///< sectional, of a hall
    barnDoor,
    wood,
    stone,
    zinc,
    bricks,
    white,
    skylight,
};

/// The corners of a cell in texture coordinates, slightly inside its edges, so that neighbours do not bleed
/// in.
struct CellUv
{
    glm::vec2 low, high;
    glm::vec2 middle() const { return (low + high) * 0.5F; }
    /// Returns a point of the cell by its shares of width and height.
    glm::vec2 at(float u, float v) const { return low + (high - low) * glm::vec2(u, v); }
};
CellUv uvOf(Detail detail);

constexpr int kDetailColumns = 4;

/// The surface of windows, doors, gutters and chimneys.
inline const Surface kHouseDetails{Painting::houseDetails, Coat::matt};

} // namespace scenery::models
