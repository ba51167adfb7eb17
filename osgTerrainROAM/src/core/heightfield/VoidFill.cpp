// SPDX-License-Identifier: Apache-2.0
#include "VoidFill.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "SplineInTension.h"

namespace osgTerrainROAM::core
{

namespace
{

/// Finds the 8-connected voids and gives each of their cells the range of its rim.
void findRims(VoidLevel& level)
{
    std::vector<std::uint8_t> seen(level.isVoid.size(), 0);
    std::vector<VoidCell> component;
    for (int r = 0; r < level.rows; ++r)
        for (int c = 0; c < level.columns; ++c)
        {
            if (!level.isVoid[level.index(c, r)] || seen[level.index(c, r)]) continue;
            component.assign(1, {c, r, 0.0f, 0.0f});
            seen[level.index(c, r)] = 1;
            float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
            for (std::size_t next = 0; next < component.size(); ++next)
                for (int k = 0; k < 9; ++k)
                {
                    const int nc = component[next].column + k % 3 - 1, nr = component[next].row + k / 3 - 1;
                    if (!level.contains(nc, nr)) continue;
                    const std::size_t n = level.index(nc, nr);
                    if (!level.isVoid[n])
                    {
                        low = std::min(low, level.heightsM[n]);
                        high = std::max(high, level.heightsM[n]);
                    }
                    else if (!seen[n])
                    {
                        seen[n] = 1;
                        component.push_back({nc, nr, 0.0f, 0.0f});
                    }
                }
            for (VoidCell cell : component)
                level.voids.push_back({cell.column, cell.row, low, high});
        }
}

/// Halves the resolution: a coarse cell is known when any of its four cells is, with their mean.
VoidLevel coarsened(const VoidLevel& fine)
{
    VoidLevel coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, 2.0 * fine.samplesPerCell, {}, {}, {}};
    const std::size_t cells = static_cast<std::size_t>(coarse.columns) * coarse.rows;
    coarse.heightsM.assign(cells, 0.0f);
    coarse.isVoid.assign(cells, 0);
    for (int r = 0; r < coarse.rows; ++r)
        for (int c = 0; c < coarse.columns; ++c)
        {
            double sum = 0.0;
            int known = 0;
            for (int k = 0; k < 4; ++k)
            {
                const int fc = 2 * c + k % 2, fr = 2 * r + k / 2;
                if (!fine.contains(fc, fr) || fine.isVoid[fine.index(fc, fr)]) continue;
                sum += fine.heightsM[fine.index(fc, fr)];
                ++known;
            }
            coarse.isVoid[coarse.index(c, r)] = known == 0;
            if (known) coarse.heightsM[coarse.index(c, r)] = static_cast<float>(sum / known);
        }
    // Ranges come from any one fine cell; all four belong to the same void.
    for (const VoidCell& cell : fine.voids)
        if (cell.column % 2 == 0 && cell.row % 2 == 0 &&
            coarse.isVoid[coarse.index(cell.column / 2, cell.row / 2)])
            coarse.voids.push_back({cell.column / 2, cell.row / 2, cell.lowM, cell.highM});
    return coarse;
}

/// Initialises the voids of `fine` from the solution of `coarse`, bilinearly.
void startFrom(const VoidLevel& coarse, VoidLevel& fine)
{
    for (const VoidCell& cell : fine.voids)
    {
        // The centre of fine cell c lies at (c - 0.5) / 2 in coarse cells.
        const double x = std::clamp(0.5 * cell.column - 0.25, 0.0, coarse.columns - 1.0);
        const double y = std::clamp(0.5 * cell.row - 0.25, 0.0, coarse.rows - 1.0);
        const int c = static_cast<int>(x), r = static_cast<int>(y);
        const int c1 = std::min(c + 1, coarse.columns - 1), r1 = std::min(r + 1, coarse.rows - 1);
        const double south =
            std::lerp(coarse.heightsM[coarse.index(c, r)], coarse.heightsM[coarse.index(c1, r)], x - c);
        const double north =
            std::lerp(coarse.heightsM[coarse.index(c, r1)], coarse.heightsM[coarse.index(c1, r1)], x - c);
        fine.heightsM[fine.index(cell.column, cell.row)] =
            std::clamp(static_cast<float>(std::lerp(south, north, y - r)), cell.lowM, cell.highM);
    }
}

} // namespace

VoidReport fillVoids(std::span<float> heightsM, int columns, int rows)
{
    VoidReport report;
    report.count = static_cast<std::size_t>(
        std::count_if(heightsM.begin(), heightsM.end(), [](float h) { return std::isnan(h); }));
    if (report.count == 0 || report.count == heightsM.size()) return report;

    std::vector<VoidLevel> levels(1,
                                  VoidLevel{columns, rows, 1.0, {heightsM.begin(), heightsM.end()}, {}, {}});
    levels[0].isVoid.reserve(heightsM.size());
    for (const float h : heightsM)
        levels[0].isVoid.push_back(std::isnan(h));
    findRims(levels[0]);
    while (!levels.back().voids.empty())
        levels.push_back(coarsened(levels.back()));
    for (std::size_t i = levels.size() - 1; i-- > 0;)
    {
        startFrom(levels[i + 1], levels[i]);
        relaxSpline(levels[i]);
    }
    for (const VoidCell& cell : levels[0].voids)
    {
        const std::size_t i = levels[0].index(cell.column, cell.row);
        heightsM[i] = levels[0].heightsM[i];
    }
    report.share = static_cast<double>(report.count) / static_cast<double>(heightsM.size());
    report.method = "spline in tension from the rims, within their range";
    return report;
}

} // namespace osgTerrainROAM::core
