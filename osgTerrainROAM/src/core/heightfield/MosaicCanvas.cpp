// SPDX-License-Identifier: Apache-2.0
#include "MosaicCanvas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "FrameTransform.h"
#include "RasterSampler.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

constexpr double kOnSample = 1e-3;

/// The coordinates in a raster of the points of a row.
void rowOfPlaces(const GridRect& rect, int row, const FrameTransform& transform,
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

} // namespace

/// The bounds of a raster's samples in the coordinates of another grid.
Result<GridRect> rectOn(const GridReference& grid, const MosaicSource& source, GdalSession& gdal)
{
    const auto transform = FrameTransform::create(source.name, source.reference(), grid, gdal);
    if (!transform) return transform.error();
    constexpr int kPieces = 64; // of an edge, which may be curved in another reference system
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

double spacingBelow(std::span<const LaidRaster> laid, const GridRect& rect)
{
    double widestM = 0.0, withinM = std::numeric_limits<double>::infinity();
    for (const LaidRaster& other : laid)
    {
        widestM = std::max(widestM, other.spacingM);
        const bool isWithin = rect.cutTo(other.rect.grownBy(-1)) == rect;
        if (isWithin) withinM = std::min(withinM, other.spacingM);
    }
    return std::min(widestM, withinM);
}

/// Four samples of the bent raster and some points of the grid; fewer for a raster of which only every n-th
/// sample is used.
int bendingReach(double gridM, double rasterM, double belowM)
{
    constexpr double kSlack = 0.01;
    const int least = isFinerThanGrid(rasterM, gridM) ? 2 : 8;
    return std::max(least, 4 * static_cast<int>(std::ceil(belowM / gridM - kSlack)));
}

MosaicCanvas::MosaicCanvas(const GridReference& grid, const GridRect& rect, double spacingM, double coarsestM)
    : _grid(grid), _spacingM(spacingM), _coarsestStep(coarsestM / spacingM)
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

Outcome MosaicCanvas::add(const MosaicSource& source, GdalSession& gdal, MosaicReport& report)
{
    const auto rect = rectOn(_grid, source, gdal);
    if (!rect) return rect.error();
    const double stepPlaces = source.spacingM / _spacingM;
    const auto transform = FrameTransform::create(source.name, _grid, source.reference(), gdal);
    if (!transform) return transform.error();
    HeightSheet sheet{rect->cutTo(_ground.rect), {}};
    if (sheet.rect.isEmpty()) return foundation::success();
    sheet.heightsM.assign(static_cast<std::size_t>(sheet.columns()) * static_cast<std::size_t>(sheet.rows()),
                          std::numeric_limits<float>::quiet_NaN());
    sampleInto(sheet, source.raster, *transform, stepPlaces);
    const int reach = bendingReach(_spacingM, source.spacingM, spacingBelow(_laid, *rect));
    const SeamReport seam = bendTowards(_ground, sheet, reach);
    report.bentSamples += seam.bent;
    report.largestStepM = std::max(report.largestStepM, seam.largestM);
    for (int row = sheet.rect.south; row <= sheet.rect.north; ++row)
        for (int column = sheet.rect.west; column <= sheet.rect.east; ++column)
            if (const float h = sheet.at(column, row); !std::isnan(h)) _ground.at(column, row) = h;
    _laid.push_back({*rect, source.spacingM});
    return foundation::success();
}

Raster MosaicCanvas::release() &&
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

/// Works row by row; between reference systems PROJ transforms every kEvery-th point, and the rest is
/// interpolated.
void MosaicCanvas::sampleInto(HeightSheet& sheet, const Raster& raster, const FrameTransform& transform,
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

/// Notes that a raster comes within `beyond` grid steps of a point. A pixel is as wide as its raster's step:
/// where the pixels of two rasters meet, there is no gap between them.
void MosaicCanvas::mark(int column, int row, double beyond, double stepPlaces)
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

} // namespace osgTerrainROAM::core
