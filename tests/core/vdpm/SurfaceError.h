// SPDX-License-Identifier: Apache-2.0
// Errors of a drawn triangulation, found by rasterising it; no part of the library's measuring is used.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <viewlod/ScreenError.h>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace testsupport
{

/// The largest distance of a sample from the drawn point at its place in the grid.
struct SurfaceError
{
    double errorM = 0.0;
    double errorPx = 0.0;        ///< of visible samples beyond the near distance, with the view's real matrix
    std::size_t uncovered = 0;   ///< samples under no triangle
    std::size_t turned = 0;      ///< triangles that are turned over in the plan
    std::vector<float> heightsM; ///< of the drawn surface, by sample
};

inline double errorPxOf(const viewlod::ViewState& view, const glm::dvec3& sample, const glm::dvec3& drawn)
{
    const auto wanted = viewlod::projectPx(view, sample);
    const bool isSeen =
        wanted && wanted->x >= 0 && wanted->y >= 0 && wanted->x <= view.widthPx && wanted->y <= view.heightPx;
    if (!isSeen) return 0.0;
    const auto shown = viewlod::projectPx(view, drawn);
    return shown ? glm::distance(*wanted, *shown) : std::numeric_limits<double>::infinity();
}

inline SurfaceError surfaceError(const osgTerrainROAM::core::RoamTile& tile,
                                 const osgTerrainROAM::core::DrawnMesh& mesh, const viewlod::ViewState* view)
{
    const auto& placed = tile.tile;
    const int columns = placed.field().columns, rows = placed.field().rows;
    std::vector<bool> isCovered(static_cast<std::size_t>(columns) * rows, false);
    const double kPlanRounding = mesh.isMorphed ? 1e-4 : 0.0, kBorder = mesh.isMorphed ? 1e-4 : 1e-12;
    SurfaceError error;
    error.heightsM.assign(isCovered.size(), 0.0f);
    for (const auto& t : mesh.triangles)
    {
        double x[3], y[3];
        glm::dvec3 at[3];
        for (int c = 0; c < 3; ++c)
        {
            at[c] = mesh.position(t.vertices[c]);
            // Vertices that move lie between samples; on a plane their places tell where.
            x[c] = mesh.isMorphed ? at[c].x / placed.field().spacingEastM : mesh.grid[t.vertices[c]].column;
            y[c] = mesh.isMorphed ? at[c].y / placed.field().spacingNorthM : mesh.grid[t.vertices[c]].row;
        }
        const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (area < -kPlanRounding) ++error.turned;
        if (area <= kPlanRounding) continue;
        const auto [south, north] = std::minmax({y[0], y[1], y[2]});
        const auto [west, east] = std::minmax({x[0], x[1], x[2]});
        for (double row = std::ceil(south); row <= north; ++row)
            for (double column = std::ceil(west); column <= east; ++column)
            {
                const double b = ((column - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (row - y[0])) / area;
                const double c = ((x[1] - x[0]) * (row - y[0]) - (column - x[0]) * (y[1] - y[0])) / area;
                if (!(b >= -kBorder && c >= -kBorder && b + c <= 1.0 + kBorder)) continue;
                const int i = static_cast<int>(column), j = static_cast<int>(row);
                isCovered[static_cast<std::size_t>(j) * columns + i] = true;
                const glm::dvec3 sample = placed.position(i, j),
                                 drawn = at[0] * (1.0 - b - c) + at[1] * b + at[2] * c;
                error.heightsM[static_cast<std::size_t>(j) * columns + i] = static_cast<float>(drawn.z);
                error.errorM = std::max(error.errorM, glm::distance(sample, drawn));
                if (view) error.errorPx = std::max(error.errorPx, errorPxOf(*view, sample, drawn));
            }
    }
    error.uncovered = static_cast<std::size_t>(std::ranges::count(isCovered, false));
    return error;
}

} // namespace testsupport
