// SPDX-License-Identifier: Apache-2.0
// Surface of TileSamples between the samples: the raster with its sheets over it. And the blend of each
// sheet's border into the surface below it.
#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include <osgTerrainROAM/core/heightfield/TileSamples.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Interpolates on one of the two triangles of a cell; the diagonal joins points whose column + row, in
/// cells, is even.
template<class HeightAt>
double heightInCell(int column, int row, int west, int south, int step, const HeightAt& heightAt)
{
    const double east = static_cast<double>(column - west) / step,
                 north = static_cast<double>(row - south) / step;
    const auto corner = [&](int e, int n) -> double { return heightAt(west + e * step, south + n * step); };
    const bool isEven = ((west / step + south / step) & 1) == 0;
    if (isEven)
    {
        const double sw = corner(0, 0), ne = corner(1, 1);
        if (east >= north)
        {
            const double se = corner(1, 0);
            return sw + east * (se - sw) + north * (ne - se);
        }
        const double nw = corner(0, 1);
        return sw + north * (nw - sw) + east * (ne - nw);
    }
    const double se = corner(1, 0), nw = corner(0, 1);
    if (east + north <= 1.0)
    {
        const double sw = corner(0, 0);
        return sw + east * (se - sw) + north * (nw - sw);
    }
    const double ne = corner(1, 1);
    return ne + (1.0 - east) * (nw - ne) + (1.0 - north) * (se - ne);
}

bool isInside(const GridRect& r, int column, int row)
{
    return column > r.west && row > r.south && column < r.east && row < r.north;
}

} // namespace

float TileSamples::surfaceM(int column, int row, std::size_t sheets) const
{
    while (sheets-- > 0)
    {
        const SampleSheet& sheet = _sheets[sheets];
        if (!isInside(sheet.rect(), column, row)) continue;
        if (sheet.holds(column, row)) return sheet.table().heightM(sheet.index(column, row));
        const int step = sheet.step();
        return static_cast<float>(heightInCell(column, row, column & -step, row & -step, step,
                                               [&](int c, int r) { return surfaceM(c, r, sheets + 1); }));
    }
    if (_grid.isOfRaster(column, row)) return _table.heightM(_grid.rasterIndex(column, row));
    const int step = _grid.cellSide();
    const int west = std::min(column & -step, _grid.dataColumns() - 1 - step);
    const int south = std::min(row & -step, _grid.dataRows() - 1 - step);
    return static_cast<float>(heightInCell(column, row, west, south, step,
                                           [this](int c, int r)
                                           { return _table.heightM(_grid.rasterIndex(c, r)); }));
}

const SampleSheet* TileSamples::sheetAt(int column, int row) const
{
    for (std::size_t i = _sheets.size(); i-- > 0;)
        if (_sheets[i].holds(column, row)) return &_sheets[i];
    return nullptr;
}

/// Lays sheets over the raster, coarse before fine, and blends each into the surface below over its outermost
/// cells.
void TileSamples::laySheets(std::vector<DensePart> parts, Storage storage)
{
    _sheets.reserve(parts.size());
    for (DensePart& part : parts)
    {
        fade(part);
        _sheets.emplace_back(part, _grid.exponent(), storage);
        part.heightsM = {};
    }
    const int cell = _grid.cellSide();
    for (std::size_t i = 0; i < _sheets.size(); ++i)
    {
        const GridRect& rect = _sheets[i].rect();
        for (int row = rect.south + cell; row < rect.north; row += cell)
            for (int column = rect.west + cell; column < rect.east; column += cell)
            {
                _table.setHeight(_grid.rasterIndex(column, row), surfaceM(column, row, _sheets.size()));
                _table.setElsewhere(_grid.rasterIndex(column, row), true);
            }
    }
}

void TileSamples::fade(DensePart& part) const
{
    const int step = 1 << (_grid.exponent() - part.exponent),
              cell = 1 << part.exponent; // of the grid; of the part
    const int columns = part.columns * cell, rows = part.rows * cell;
    const auto index = [&](int c, int r) {
        return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns + 1) +
               static_cast<std::size_t>(c);
    };
    const auto lieFlush = [&](int c, int r)
    {
        const double t = std::min({c, r, columns - c, rows - r}) / static_cast<double>(cell);
        const float belowM = surfaceM((part.west << _grid.exponent()) + c * step,
                                      (part.south << _grid.exponent()) + r * step, _sheets.size());
        float& heightM = part.heightsM[index(c, r)];
        heightM =
            static_cast<float>(std::lerp(double{belowM}, double{heightM}, glm::smoothstep(0.0, 1.0, t)));
    };
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c)
        {
            if (r > cell && r < rows - cell && c == cell) c = columns - cell; // only the outermost cells
            lieFlush(c, r);
        }
}

} // namespace osgTerrainROAM::core
