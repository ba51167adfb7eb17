// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <foundation/Heights.h>
#include <glm/glm.hpp>

#include "worldmaking/plan/PlanGrid.h"

namespace worldmaking
{

/// Heights of the ground at the points of a square grid over a part of the plane, for those that make up a
/// map. Units: metres.
class GroundGrid
{
public:
    /// Makes what a thread of its own asks for heights.
    using HeightMaker = std::function<foundation::HeightInPlan()>;

    /// Asks for the height of each point, in many threads, each of what was made for it. Where there is none
    /// the grid has no ground.
    GroundGrid(const MapBox& box, double cellM, const HeightMaker& heights);
    GroundGrid(const MapBox& box, double cellM, const foundation::HeightInPlan& height)
        : GroundGrid(box, cellM, HeightMaker([&height] { return height; }))
    {
    }

    int columns() const { return _columns; }
    int rows() const { return _rows; }
    double cellM() const { return _cellM; }
    const MapBox& box() const { return _box; }
    std::size_t size() const { return _heights.size(); }
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(_columns) +
               static_cast<std::size_t>(column);
    }
    glm::dvec2 placeOf(int column, int row) const { return _box.low + _cellM * glm::dvec2(column, row); }
    double heightAt(int column, int row) const { return _heights[index(column, row)]; }
    bool hasGround(int column, int row) const { return _heights[index(column, row)] > kNoGround; }

    /// The height between grid points, bilinear. Nothing: beyond the grid, or where it has no ground.
    std::optional<double> heightM(const glm::dvec2& place) const;

    /// Metres of climb a metre eastwards and northwards, over two cells. Zero where there is no ground.
    glm::dvec2 gradient(const glm::dvec2& place) const;
    double slope(const glm::dvec2& place) const { return glm::length(gradient(place)); }

    /// Whether a place is ground above the sea. Where a hundredth of the ground or more lies at 0 or below, 0
    /// is the sea's level.
    bool isLand(const glm::dvec2& place) const;
    bool hasSea() const { return _hasSea; }

    static constexpr float kNoGround = -1e4F;
    static constexpr double kShoreM = 0.4; ///< land is at least so high above the sea

private:
    MapBox _box;
    double _cellM;
    int _columns, _rows;
    bool _hasSea = false;
    std::vector<float> _heights; ///< row by row, the southernmost first; kNoGround where there is none
};

} // namespace worldmaking
