// SPDX-License-Identifier: Apache-2.0
#include "SheetErrors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "RowDistance.h"

namespace osgTerrainROAM::core
{

SheetErrors::SheetErrors(const PlacedTile& tile) : _tile(tile)
{
    for (const SampleSheet& sheet : tile.samples().sheets())
    {
        std::vector<glm::dvec3>& positions = _positions.emplace_back();
        positions.reserve(sheet.table().size());
        sheet.inside().forEachMultipleOf(sheet.step(),
                                         [&](int column, int row) {
                                             positions.push_back(tile.samples().isGround(column, row)
                                                                     ? tile.position(column, row)
                                                                     : kNoSample);
                                         });
    }
}

double SheetErrors::largestM(const GridTriangle& t) const
{
    const auto position = [this](GridPoint p) { return _tile.position(p.column, p.row); };
    const glm::dvec3 origin = position(t.apex), du = position(t.left) - origin,
                     dw = position(t.right) - origin;
    const auto east = t.perColumn();
    double largest2 = 0.0;
    for (std::size_t i = 0; i < _positions.size(); ++i)
    {
        const SampleSheet& sheet = _tile.samples().sheets()[i];
        const GridRect inside = sheet.inside();
        if (inside.cutTo(t.extent()).isEmpty()) continue;
        const int step = sheet.step(), perRow = (inside.east - inside.west) / step + 1;
        const glm::dvec3 perColumn = (du * east.u + dw * east.w) * static_cast<double>(step);
        t.forEachRow(
            inside.east + 1, inside.north + 1,
            [&](int row, int west, int eastmost)
            {
                west = std::max(west, inside.west);
                if (row < inside.south || west > eastmost) return;
                const glm::dvec3* sample =
                    &_positions[i][static_cast<std::size_t>((row - inside.south) / step) *
                                       static_cast<std::size_t>(perRow) +
                                   static_cast<std::size_t>((west - inside.west) / step)];
                const auto b = t.at(west, row);
                const glm::dvec3 start = origin + du * b.u + dw * b.w;
                largest2 =
                    largestSquared(largest2, sample, (eastmost - west) / step + 1, start, perColumn, 0);
            },
            step);
    }
    return std::sqrt(largest2);
}

} // namespace osgTerrainROAM::core
