// SPDX-License-Identifier: Apache-2.0
#include "DemMosaic.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "HoleFill.h"
#include "MosaicCanvas.h"
#include "MosaicPlan.h"
#include "VoidFill.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Outcome;
using foundation::Result;

/// Sorts coarse before fine; among equals the first named comes last, and lies on top.
void sortForLaying(std::vector<MosaicSource>& sources)
{
    std::reverse(sources.begin(), sources.end());
    const auto rank = [](const MosaicSource& s) { return std::lround(64.0 * std::log2(s.spacingM)); };
    std::stable_sort(sources.begin(), sources.end(),
                     [&](const MosaicSource& a, const MosaicSource& b) { return rank(a) > rank(b); });
}

/// What rasters are laid on: a rectangle of a grid.
struct MosaicGround
{
    GridReference grid;
    GridRect rect;
    double spacingM;
    bool takesFiner; ///< than the grid
};

Result<Raster> painted(const MosaicGround& ground, const std::vector<MosaicSource>& sources,
                       GdalSession& gdal, MosaicReport& report)
{
    MosaicCanvas canvas(ground.grid, ground.rect, ground.spacingM, sources.front().spacingM);
    for (const MosaicSource& source : sources)
        if (ground.takesFiner || !isFinerThanGrid(source.spacingM, ground.spacingM))
            if (const Outcome added = canvas.add(source, gdal, report); !added) return added.error();
    return std::move(canvas).release();
}

Result<DensePart> partOf(const MosaicPlan& plan, const PlannedPart& planned,
                         const std::vector<MosaicSource>& sources, GdalSession& gdal, MosaicReport& report)
{
    const auto onPart = [&](int cell) { return cell << planned.exponent; };
    const GridRect& cells = planned.cells;
    const GridRect rect{onPart(cells.west), onPart(cells.south), onPart(cells.east), onPart(cells.north)};
    auto raster = painted(
        {scaled(plan.grid, -planned.exponent), rect, std::ldexp(plan.spacingM, -planned.exponent), false},
        sources, gdal, report);
    if (!raster) return raster.error();
    fillOutside(raster->heightsM, raster->isOutside, raster->columns, raster->rows);
    fillVoids(raster->heightsM, raster->columns, raster->rows);
    return DensePart{cells.west - plan.rect.west,
                     cells.south - plan.rect.south,
                     cells.east - cells.west,
                     cells.north - cells.south,
                     planned.exponent,
                     std::move(raster->heightsM)};
}

} // namespace

Result<Raster> readMosaic(std::span<const std::filesystem::path> files, const DemImportOptions& options,
                          GdalSession& gdal, MosaicReport& report)
{
    auto sources = readSources(files, options, gdal);
    if (!sources) return sources.error();
    sortForLaying(*sources);
    const auto plan = planMosaic(*sources, gdal);
    if (!plan) return plan.error();
    auto joined = painted({plan->grid, plan->rect, plan->spacingM, true}, *sources, gdal, report);
    if (!joined) return joined.error();
    for (const PlannedPart& planned : plan->parts)
    {
        auto part = partOf(*plan, planned, *sources, gdal, report);
        if (!part) return part.error();
        joined->parts.push_back(std::move(*part));
    }
    report.rasters = static_cast<int>(files.size());
    for (const MosaicSource& source : *sources)
        joined->implausible += source.raster.implausible;
    return joined;
}

} // namespace osgTerrainROAM::core
