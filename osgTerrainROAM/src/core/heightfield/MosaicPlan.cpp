// SPDX-License-Identifier: Apache-2.0
#include "MosaicPlan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "MosaicCanvas.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

constexpr double kMostSamples = 1 << 26; ///< in all; 400 MB in a tile
constexpr double kMostUnderParts = 1 << 24;
constexpr int kMostSide = 32769;
constexpr int kMostExponent = 12;
constexpr int kMargin = 2; ///< cells around a finer raster and the ground that is bent towards it

double placesOf(const GridRect& rect)
{
    return (rect.east - rect.west + 1.0) * (rect.north - rect.south + 1.0);
}

GridRect joined(const GridRect& a, const GridRect& b)
{
    return {std::min(a.west, b.west), std::min(a.south, b.south), std::max(a.east, b.east),
            std::max(a.north, b.north)};
}

/// The points, within a rectangle, of a grid that is coarser by 2^exponent.
GridRect coarser(const GridRect& rect, int exponent)
{
    const auto down = [=](int v) { return v >> exponent; };
    const auto up = [=](int v) { return -(-v >> exponent); };
    return {up(rect.west), up(rect.south), down(rect.east), down(rect.north)};
}

bool fits(const GridRect& rect, double mostPlaces)
{
    return rect.east - rect.west < kMostSide && rect.north - rect.south < kMostSide &&
           placesOf(rect) <= mostPlaces;
}

/// The cells around the samples of a raster, with a margin in which the ground below is bent to meet it.
GridRect cellsAround(const GridRect& onFinest, int exponent, const GridRect& all, int marginCells)
{
    const auto down = [=](int v) { return v >> exponent; };
    const auto up = [=](int v) { return -(-v >> exponent); };
    return GridRect{down(onFinest.west), down(onFinest.south), up(onFinest.east), up(onFinest.north)}
        .grownBy(marginCells)
        .cutTo(all);
}

/// Adds a part, and merges it with the parts of the same exponent that it touches.
void add(std::vector<PlannedPart>& parts, PlannedPart part)
{
    for (std::size_t i = 0; i < parts.size();)
    {
        const bool touches = !parts[i].cells.cutTo(part.cells).isEmpty();
        if (parts[i].exponent != part.exponent || !touches)
        {
            ++i;
            continue;
        }
        part.cells = joined(part.cells, parts[i].cells);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0; // it may touch others now
    }
    parts.push_back(part);
}

Outcome checkSize(const MosaicPlan& plan, const MosaicSource& finest)
{
    double samples = placesOf(plan.rect);
    for (const PlannedPart& part : plan.parts)
        samples += std::ldexp(placesOf(part.cells), 2 * part.exponent);
    if (samples <= kMostSamples) return foundation::success();
    return Error{finest.name,
                 "is so fine and large that the terrain would have " +
                     std::to_string(static_cast<long long>(samples)) + " samples",
                 "cut it down with gdal_translate -projwin, or make it coarser with -tr"};
}

} // namespace

GridReference scaled(GridReference grid, int exponent)
{
    grid.frame.stepX = std::ldexp(grid.frame.stepX, exponent);
    grid.frame.stepY = std::ldexp(grid.frame.stepY, exponent);
    return grid;
}

Result<MosaicPlan> planMosaic(std::span<const MosaicSource> sources, GdalSession& gdal)
{
    const MosaicSource& finest = sources.back();
    const GridReference grid = finest.reference();
    std::vector<GridRect> rects;
    std::vector<LaidRaster> laid;
    GridRect all{0, 0, finest.raster.columns - 1, finest.raster.rows - 1};
    for (const MosaicSource& source : sources)
    {
        const auto rect = rectOn(grid, source, gdal);
        if (!rect) return rect.error();
        rects.push_back(*rect);
        laid.push_back({*rect, source.spacingM});
        all = joined(all, *rect);
    }
    MosaicPlan plan;
    if (!fits(all, kMostSamples))
        while (plan.exponent < kMostExponent && !fits(coarser(all, plan.exponent), kMostUnderParts))
            ++plan.exponent;
    plan.grid = scaled(grid, plan.exponent);
    plan.rect = coarser(all, plan.exponent);
    plan.spacingM = std::ldexp(finest.spacingM, plan.exponent);
    if (!fits(plan.rect, kMostUnderParts) && plan.exponent > 0)
        return Error{finest.name, "lies too far from the other rasters, or is too fine among them",
                     "check its georeference with gdalinfo, or describe it in a file of its own"};
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
        const int finer = static_cast<int>(std::lround(std::log2(plan.spacingM / sources[i].spacingM)));
        if (finer <= 0) continue;
        const int bent =
            bendingReach(plan.spacingM, sources[i].spacingM, spacingBelow({laid.data(), i}, rects[i]));
        add(plan.parts, {cellsAround(rects[i], plan.exponent, plan.rect, kMargin + bent), finer});
    }
    if (const Outcome small = checkSize(plan, finest); !small) return small.error();
    return plan;
}

} // namespace osgTerrainROAM::core
