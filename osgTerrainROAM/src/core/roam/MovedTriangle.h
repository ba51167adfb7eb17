// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// A drawn triangle whose corners lie between points of the grid: of a mesh whose vertices move sideways.
/// Units: columns and rows of the grid. Borders are wide by the rounding of vertices.
struct MovedTriangle
{
    static constexpr double kRounding = 1e-4;

    std::array<glm::dvec2, 3> corners;

    double doubleArea() const
    {
        const glm::dvec2 u = corners[1] - corners[0], w = corners[2] - corners[0];
        return u.x * w.y - u.y * w.x;
    }

    /// Whether a corner lies beyond the opposite side by more than vertices are rounded: one that has just
    /// begun to move lies on it.
    bool isTurnedOver() const
    {
        const double longest =
            std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                      glm::distance(corners[2], corners[0])});
        return doubleArea() < -kRounding * std::max(longest, 1.0);
    }

    /// Calls visit(column, row, u, w) for the samples of the raster in it: a sample lies at c0 + u (c1 - c0)
    /// + w (c2 - c0).
    /// Precondition: doubleArea() > kRounding.
    template<class Visit>
    void forEachSample(const PlacedTile& tile, const Visit& visit) const
    {
        const int step = tile.grid().cellSide();
        const glm::dvec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]) - kRounding,
                         high = glm::max(glm::max(corners[0], corners[1]), corners[2]) + kRounding,
                         across = corners[1] - corners[0], up = corners[2] - corners[0];
        const auto firstIn = [step](double from)
        { return std::max(0, static_cast<int>(std::ceil(from / step))) * step; };
        const int east = std::min(static_cast<int>(high.x), tile.grid().dataColumns() - 1),
                  north = std::min(static_cast<int>(high.y), tile.grid().dataRows() - 1);
        for (int row = firstIn(low.y); row <= north; row += step)
            for (int column = firstIn(low.x); column <= east; column += step)
            {
                const glm::dvec2 off = glm::dvec2(column, row) - corners[0];
                const double u = (off.x * up.y - off.y * up.x) / doubleArea(),
                             w = (across.x * off.y - across.y * off.x) / doubleArea();
                if (u >= -kRounding && w >= -kRounding && u + w <= 1.0 + kRounding) visit(column, row, u, w);
            }
    }
};

} // namespace osgTerrainROAM::core
