// SPDX-License-Identifier: Apache-2.0
// The height of the full-resolution surface: a vertical line (z axis of the local frame) is intersected with
// the triangle at it. On the curved Earth the horizontal position of a sample depends on its height, so the
// triangle is found by fixed-point iteration: the linear map of each triangle tried gives the line's grid
// coordinates, and these the next triangle.
#include <algorithm>
#include <array>
#include <cmath>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/heightfield/VerticalHit.h>

namespace osgTerrainROAM::core
{

namespace
{

/// A triangle of the finest level by grid corners, counter-clockwise from above.
using PlanCorners = std::array<glm::ivec2, 3>;

/// The half of cell (column, row) that contains the point at `fraction` (0…1 each way). Every diagonal of the
/// finest level joins samples whose column + row is even: samples of odd column and odd row are centres of
/// the last diamonds, joined to the four even-even corners around them.
PlanCorners triangleIn(glm::ivec2 cell, glm::dvec2 fraction)
{
    const glm::ivec2 sw = cell, se = cell + glm::ivec2(1, 0), nw = cell + glm::ivec2(0, 1),
                     ne = cell + glm::ivec2(1);
    if ((cell.x + cell.y) % 2 == 0)
        return fraction.x >= fraction.y ? PlanCorners{se, ne, sw} : PlanCorners{nw, sw, ne};
    return fraction.x + fraction.y <= 1.0 ? PlanCorners{sw, se, nw} : PlanCorners{ne, nw, se};
}

class Search
{
public:
    Search(const PlacedTile& tile, glm::dvec2 target) : _tile(tile), _target(target) {}

    VerticalHit intersect(const PlanCorners& triangle) const
    {
        std::array<glm::dvec3, 3> positions;
        std::array<glm::dvec2, 3> grid;
        for (std::size_t k = 0; k < 3; ++k)
        {
            positions[k] = _tile.position(triangle[k].x, triangle[k].y);
            grid[k] = triangle[k];
        }
        return verticalHit(positions, grid, _target);
    }

    bool isGround(const PlanCorners& triangle) const
    {
        return std::all_of(triangle.begin(), triangle.end(),
                           [this](const glm::ivec2& corner)
                           { return _tile.samples().isGround(corner.x, corner.y); });
    }

    /// The cell of the data nearest to grid coordinates.
    glm::ivec2 cellAt(glm::dvec2 grid) const
    {
        return {static_cast<int>(std::clamp(std::floor(grid.x), 0.0, _tile.grid().dataColumns() - 2.0)),
                static_cast<int>(std::clamp(std::floor(grid.y), 0.0, _tile.grid().dataRows() - 2.0))};
    }

    /// Iterates over the triangles' own maps. A few steps suffice, except in steep relief far from the tile's
    /// origin.
    std::optional<VerticalHit> follow(glm::dvec2& grid) const
    {
        constexpr int kMaxSteps = 12;
        for (int step = 0; step < kMaxSteps; ++step)
        {
            const glm::ivec2 cell = cellAt(grid);
            const PlanCorners triangle = triangleIn(cell, grid - glm::dvec2(cell));
            const VerticalHit hit = intersect(triangle);
            if (hit.isInside()) return isGround(triangle) ? std::optional(hit) : std::nullopt;
            if (!std::isfinite(hit.grid.x) || !std::isfinite(hit.grid.y)) return std::nullopt;
            grid = hit.grid;
        }
        return std::nullopt;
    }

    /// Tries every triangle of the cells around grid coordinates.
    std::optional<VerticalHit> scan(glm::dvec2 grid) const
    {
        constexpr int kReach = 2;
        const glm::ivec2 middle = cellAt(grid);
        for (int row = middle.y - kReach; row <= middle.y + kReach; ++row)
            for (int column = middle.x - kReach; column <= middle.x + kReach; ++column)
            {
                const glm::ivec2 cell(column, row);
                if (cell != cellAt(glm::dvec2(cell))) continue;
                // These two points lie in different halves for either diagonal.
                for (const glm::dvec2 half : {glm::dvec2(0.75, 0.5), glm::dvec2(0.25, 0.5)})
                {
                    const PlanCorners triangle = triangleIn(cell, half);
                    if (!isGround(triangle)) continue;
                    if (const VerticalHit hit = intersect(triangle); hit.isInside()) return hit;
                }
            }
        return std::nullopt;
    }

private:
    const PlacedTile& _tile;
    glm::dvec2 _target;
};

} // namespace

std::optional<GroundPoint> groundAt(const PlacedTile& tile, double east, double north)
{
    const Search search(tile, {east, north});
    glm::dvec2 grid = tile.frame().gridNear({east, north});
    if (!std::isfinite(grid.x) || !std::isfinite(grid.y)) return std::nullopt;
    // Lines far outside are not searched; the margin covers the shift by height and curvature.
    const double margin = 0.5 * tile.grid().side();
    if (grid.x < -margin || grid.y < -margin || grid.x > tile.grid().dataColumns() + margin ||
        grid.y > tile.grid().dataRows() + margin)
        return std::nullopt;
    std::optional<VerticalHit> hit = search.follow(grid);
    if (!hit) hit = search.scan(grid);
    if (!hit) return std::nullopt;
    return GroundPoint{hit->position, hit->normal};
}

} // namespace osgTerrainROAM::core
