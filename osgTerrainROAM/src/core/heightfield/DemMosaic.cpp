// SPDX-License-Identifier: Apache-2.0
#include "DemMosaic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "FrameTransform.h"
#include "MosaicSource.h"
#include "RasterSampler.h"
#include "SeamBend.h"

namespace osgTerrainROAM::core
{

namespace
{

using viewlod::Error;
using viewlod::Outcome;
using viewlod::Result;

constexpr std::size_t kMostSamples = std::size_t{1} << 26; ///< of a mosaic: 400 MB as a tile keeps them
constexpr int kMostSide = 32769;
constexpr double kOnSample = 1e-3;
constexpr int kReachInSteps = 4; ///< of the coarser data, that bends towards finer
constexpr int kLeastReach = 8;   ///< places

/// Where the outermost samples of a raster lie on the grid of another.
Result<GridRect> rectOn(const GridReference& grid, const MosaicSource& source, GdalSession& gdal)
{
    const auto transform = FrameTransform::create(source.name, source.reference(), grid, gdal);
    if (!transform) return transform.error();
    constexpr int kPieces = 64; // of an edge, which may bend between reference systems
    std::vector<glm::dvec2> places;
    const glm::dvec2 last(source.raster.columns - 1, source.raster.rows - 1);
    for (int i = 0; i <= kPieces; ++i)
        for (const double edge : {0.0, 1.0})
        {
            places.emplace_back(last.x * i / kPieces, last.y * edge);
            places.emplace_back(last.x * edge, last.y * i / kPieces);
        }
    transform->apply(places);
    glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (const glm::dvec2& p : places)
    {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    constexpr double kMost = 1e9;
    if (!(high.x - low.x < kMost && high.y - low.y < kMost && std::abs(low.x) < kMost &&
          std::abs(low.y) < kMost))
        return Error{source.name, "lies nowhere near the other rasters",
                     "check its georeference with gdalinfo, or describe it in a file of its own"};
    return GridRect{
        static_cast<int>(std::ceil(low.x - kOnSample)), static_cast<int>(std::ceil(low.y - kOnSample)),
        static_cast<int>(std::floor(high.x + kOnSample)), static_cast<int>(std::floor(high.y + kOnSample))};
}

/// The grid that all are joined on, and what has been joined so far.
class Canvas
{
public:
    /// `coarsestStep`: of the grid, to a sample of the coarsest raster that will be laid.
    Canvas(const GridReference& grid, const GridRect& rect, double coarsestStep)
        : _grid(grid), _coarsestStep(coarsestStep)
    {
        _ground.rect = {0, 0, rect.east - rect.west, rect.north - rect.south};
        _grid.frame.firstX += rect.west * _grid.frame.stepX;
        _grid.frame.firstY += rect.south * _grid.frame.stepY;
        const std::size_t places =
            static_cast<std::size_t>(_ground.columns()) * static_cast<std::size_t>(_ground.rows());
        _ground.heightsM.assign(places, std::numeric_limits<float>::quiet_NaN());
        _reach.assign(places, Reach::none);
        _beyond.assign(places, std::numeric_limits<float>::infinity());
    }

    /// Lays a raster over what is there. `stepPlaces`: of the grid, to a sample of the raster.
    Outcome add(const MosaicSource& source, const GridRect& rect, double stepPlaces, GdalSession& gdal,
                MosaicReport& report)
    {
        const auto transform = FrameTransform::create(source.name, _grid, source.reference(), gdal);
        if (!transform) return transform.error();
        HeightSheet sheet{rect.cutTo(_ground.rect), {}};
        sheet.heightsM.assign(static_cast<std::size_t>(sheet.columns()) *
                                  static_cast<std::size_t>(sheet.rows()),
                              std::numeric_limits<float>::quiet_NaN());
        sampleInto(sheet, source.raster, *transform, stepPlaces);
        constexpr double kSlack = 0.01;
        const int reach =
            std::max(kLeastReach, kReachInSteps * static_cast<int>(std::ceil(_laidStep - kSlack)));
        const SeamReport seam = bendTowards(_ground, sheet, reach);
        report.bentSamples += seam.bent;
        report.largestStepM = std::max(report.largestStepM, seam.largestM);
        for (int row = sheet.rect.south; row <= sheet.rect.north; ++row)
            for (int column = sheet.rect.west; column <= sheet.rect.east; ++column)
                if (const float h = sheet.at(column, row); !std::isnan(h)) _ground.at(column, row) = h;
        _laidStep = std::max(_laidStep, stepPlaces);
        return viewlod::success();
    }

    Raster take() &&
    {
        Raster raster;
        raster.columns = _ground.columns();
        raster.rows = _ground.rows();
        raster.frame = _grid.frame;
        raster.crsWkt = _grid.crsWkt;
        raster.isOutside.reserve(_reach.size());
        for (std::size_t i = 0; i < _reach.size(); ++i)
            raster.isOutside.push_back(std::isnan(_ground.heightsM[i]) && _reach[i] == Reach::none);
        raster.heightsM = std::move(_ground.heightsM);
        return raster;
    }

private:
    enum class Reach : std::uint8_t
    {
        none,
        between, ///< in a gap that is no wider than the samples beside it stand apart
        inside,  ///< of a raster's outermost samples
    };

    /// Row by row; between reference systems PROJ is asked for every kEvery-th place.
    void sampleInto(HeightSheet& sheet, const Raster& raster, const FrameTransform& transform,
                    double stepPlaces)
    {
        const RasterSampler sampler(raster);
        const int gap = static_cast<int>(std::ceil(0.5 * (stepPlaces + _coarsestStep)));
        const GridRect around = sheet.rect.grownBy(gap).cutTo(_ground.rect);
        std::vector<glm::dvec2> places;
        for (int row = around.south; row <= around.north; ++row)
        {
            rowOfPlaces(around, row, transform, places);
            for (int column = around.west; column <= around.east; ++column)
            {
                const glm::dvec2& place = places[static_cast<std::size_t>(column - around.west)];
                mark(column, row, stepPlaces * sampler.beyond(place), stepPlaces);
                if (sheet.holds(column, row)) sheet.at(column, row) = sampler.heightM(place);
            }
        }
    }

    static void rowOfPlaces(const GridRect& rect, int row, const FrameTransform& transform,
                            std::vector<glm::dvec2>& places)
    {
        constexpr int kEvery = 16;
        const int count = rect.east - rect.west + 1;
        places.clear();
        if (transform.isExact())
        {
            for (int column = rect.west; column <= rect.east; ++column)
                places.emplace_back(column, row);
            return transform.apply(places);
        }
        std::vector<glm::dvec2> nodes;
        for (int column = rect.west; column <= rect.east + kEvery; column += kEvery)
            nodes.emplace_back(column, row);
        transform.apply(nodes);
        for (int i = 0; i < count; ++i)
            places.push_back(glm::mix(nodes[static_cast<std::size_t>(i / kEvery)],
                                      nodes[static_cast<std::size_t>(i / kEvery) + 1],
                                      static_cast<double>(i % kEvery) / kEvery));
    }

    /// Notes that a raster comes within `beyond` places of a place. Each pixel is as wide as its raster's step: where those of two
    /// rasters meet, nothing is missing between their middles.
    void mark(int column, int row, double beyond, double stepPlaces)
    {
        constexpr double kSlack = 0.01;
        const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(_ground.columns()) +
                              static_cast<std::size_t>(column);
        const double beyondPixel = beyond - 0.5 * stepPlaces;
        if (beyond == 0.0)
            _reach[i] = Reach::inside;
        else if (_reach[i] == Reach::none && _beyond[i] + beyondPixel <= kSlack)
            _reach[i] = Reach::between;
        _beyond[i] = std::min(_beyond[i], static_cast<float>(beyondPixel));
    }

    GridReference _grid;
    HeightSheet _ground;
    const double _coarsestStep;
    std::vector<Reach> _reach;
    std::vector<float> _beyond; ///< the pixels of the raster that comes nearest
    double _laidStep = 1.0;     ///< places to a sample, of the coarsest that has been laid so far
};

Outcome checkSize(const MosaicSource& finest, const GridRect& rect)
{
    const double columns = rect.east - rect.west + 1.0, rows = rect.north - rect.south + 1.0;
    if (columns <= kMostSide && rows <= kMostSide && columns * rows <= static_cast<double>(kMostSamples))
        return viewlod::success();
    return Error{
        finest.name,
        "is so fine that the whole terrain at its spacing would have " +
            std::to_string(static_cast<long long>(columns)) + " x " +
            std::to_string(static_cast<long long>(rows)) + " samples",
        "cut the other rasters down with gdal_translate -projwin, or make this one coarser with -tr"};
}

/// Coarse before fine; among equals the first named comes last, and lies on top.
std::vector<std::size_t> layingOrder(std::span<const MosaicSource> sources)
{
    std::vector<std::size_t> order;
    for (std::size_t i = sources.size(); i-- > 0;)
        order.push_back(i);
    const auto rank = [&](std::size_t i) { return std::lround(64.0 * std::log2(sources[i].spacingM)); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return rank(a) > rank(b); });
    return order;
}

} // namespace

Result<Raster> readMosaic(std::span<const std::filesystem::path> files, const DemImportOptions& options,
                          GdalSession& gdal, MosaicReport& report)
{
    const auto sources = readSources(files, options, gdal);
    if (!sources) return sources.error();
    const std::vector<std::size_t> order = layingOrder(*sources);
    const MosaicSource& finest = (*sources)[order.back()];
    const GridReference grid = finest.reference();
    std::vector<GridRect> rects;
    GridRect all{0, 0, finest.raster.columns - 1, finest.raster.rows - 1};
    for (const MosaicSource& source : *sources)
    {
        const auto rect = rectOn(grid, source, gdal);
        if (!rect) return rect.error();
        rects.push_back(*rect);
        all = {std::min(all.west, rect->west), std::min(all.south, rect->south),
               std::max(all.east, rect->east), std::max(all.north, rect->north)};
    }
    if (const Outcome fits = checkSize(finest, all); !fits) return fits.error();
    Canvas canvas(grid, all, (*sources)[order.front()].spacingM / finest.spacingM);
    for (const std::size_t i : order)
    {
        const GridRect& r = rects[i];
        const GridRect onCanvas{r.west - all.west, r.south - all.south, r.east - all.west,
                                r.north - all.south};
        const double stepPlaces = (*sources)[i].spacingM / finest.spacingM;
        if (const Outcome added = canvas.add((*sources)[i], onCanvas, stepPlaces, gdal, report); !added)
            return added.error();
    }
    report.rasters = static_cast<int>(files.size());
    Raster joined = std::move(canvas).take();
    for (const MosaicSource& source : *sources)
        joined.implausible += source.raster.implausible;
    return joined;
}

} // namespace osgTerrainROAM::core
