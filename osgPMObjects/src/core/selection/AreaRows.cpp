// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>

#include <osgPMObjects/core/selection/AreaRows.h>

namespace osgPMObjects::core
{

AreaRows AreaRows::halving(const LevelTable& table, double pixelsPerTriangle, std::uint32_t leastFaces)
{
    AreaRows rows;
    rows.steps.push_back(0);
    for (std::uint32_t faces = table.faces.front();;)
    {
        // A row of `faces` ends where each visible face covers too little.
        const double least = 0.5 * faces * pixelsPerTriangle;
        faces /= 2;
        if (faces < std::max(1u, leastFaces)) break;
        const auto level = std::partition_point(table.faces.begin(), table.faces.end(),
                                                [&](std::uint32_t f) { return f > faces; });
        if (level == table.faces.end()) break;
        const auto steps = static_cast<std::uint32_t>(level - table.faces.begin());
        if (steps == rows.steps.back()) continue;
        rows.leastPx.push_back(least);
        rows.steps.push_back(steps);
    }
    return rows;
}

bool isAreaRows(const AreaRows& rows)
{
    const auto& least = rows.leastPx;
    return rows.steps.size() == least.size() + 1 && (least.empty() || least.back() > 0.0) &&
           std::all_of(least.begin(), least.end(), [](double area) { return std::isfinite(area); }) &&
           std::adjacent_find(least.begin(), least.end(), std::less_equal<>()) == least.end() &&
           std::is_sorted(rows.steps.begin(), rows.steps.end());
}

std::uint32_t areaRowAt(const AreaRows& rows, double areaPx, double band, HeldLevel held)
{
    const double left = areaPx * band * band;
    return heldRow(
        held, static_cast<std::uint32_t>(rows.leastPx.size()),
        [&](std::uint32_t row) { return left < rows.leastPx[row - 1]; },
        [&](std::uint32_t row) { return areaPx >= rows.leastPx[row - 1]; });
}

} // namespace osgPMObjects::core
