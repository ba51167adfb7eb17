// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/heightfield/DemCheck.h>
#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/heightfield/GridPlace.h>

#include "DemMosaic.h"
#include "HoleFill.h"
#include "MosaicSource.h"
#include "PlaceField.h"
#include "RasterFile.h"
#include "TriangulatedRaster.h"
#include "VoidFill.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

/// Marks the samples that do not exist.
void openHoles(HeightField& field, std::vector<std::uint8_t> isOutside, Voids voids)
{
    isOutside.resize(field.heightsM.size(), 0);
    if (voids == Voids::keep)
        for (std::size_t i = 0; i < isOutside.size(); ++i)
            isOutside[i] = isOutside[i] || std::isnan(field.heightsM[i]);
    if (std::none_of(isOutside.begin(), isOutside.end(), [](std::uint8_t outside) { return outside != 0; }))
        return;
    fillOutside(field.heightsM, isOutside, field.columns, field.rows);
    for (std::uint8_t& sample : isOutside)
        sample = !sample;
    field.mask = SampleMask(isOutside, field.columns, field.rows);
}

/// Tells the samples that have a height from the voids.
SampleMask finiteSamples(const HeightField& field)
{
    std::vector<std::uint8_t> isThere;
    isThere.reserve(field.heightsM.size());
    for (const float h : field.heightsM)
        isThere.push_back(std::isnan(h) ? 0 : 1);
    const bool all =
        std::none_of(isThere.begin(), isThere.end(), [](std::uint8_t there) { return there == 0; });
    return all ? SampleMask() : SampleMask(isThere, field.columns, field.rows);
}

/// Errors: a multi-triangulation among others.
Outcome checkAlone(const std::filesystem::path& file, std::size_t files)
{
    if (files == 1 || !isTriangulation(file)) return foundation::success();
    return Error{file.string(), "is a multi-triangulation, which cannot be joined with others",
                 "join its inputs before, with terraintool mt-build"};
}

std::string namesOf(std::span<const std::filesystem::path> files)
{
    return files.front().string() +
           (files.size() > 1 ? " and " + std::to_string(files.size() - 1) + " more" : "");
}

Result<HeightField> import(std::span<const std::filesystem::path> files, const DemImportOptions& options,
                           std::optional<GridPlace>& place)
{
    for (const std::filesystem::path& file : files)
        if (const Outcome alone = checkAlone(file, files.size()); !alone) return alone.error();
    GdalSession gdal;
    HeightField field;
    Result<Raster> raster =
        files.size() == 1 ? readRaster(files.front(), gdal) : readMosaic(files, options, gdal, field.mosaic);
    if (!raster) return raster.error();

    field.name = namesOf(files);
    field.columns = raster->columns;
    field.rows = raster->rows;
    if (const Outcome placed = placeField(field, *raster, options, gdal); !placed) return placed.error();
    place = placeOf(*raster);

    field.heightsM = std::move(raster->heightsM);
    field.parts = std::move(raster->parts);
    if (std::none_of(field.heightsM.begin(), field.heightsM.end(), [](float h) { return std::isfinite(h); }))
        return Error{field.name,
                     "holds no height: every sample is void" +
                         (raster->implausible ? ", or outside -12000 to 9000 m" : std::string()),
                     "check its nodata value and units with gdalinfo"};
    openHoles(field, std::move(raster->isOutside), options.voids);
    field.measured = finiteSamples(field);
    field.voids = fillVoids(field.heightsM, field.columns, field.rows);
    if (raster->implausible)
        field.voids.method +=
            "; " + std::to_string(raster->implausible) + " of them for heights outside -12000 to 9000 m";
    field.notes = gdal.notes();
    return field;
}

} // namespace

Outcome checkDems(std::span<const std::filesystem::path> files, const DemImportOptions& options)
{
    GdalSession gdal;
    for (const std::filesystem::path& file : files)
    {
        if (const Outcome alone = checkAlone(file, files.size()); !alone) return alone;
        Result<Raster> head = readHead(file, gdal);
        if (!head) return head.error();
        HeightField field;
        field.name = file.string();
        // Where a raster has a frame, placing it takes long, and seldom fails.
        const Outcome placed = files.size() > 1 ? checkPlaced(file, *head)
                               : head->frame    ? foundation::success()
                                                : placeField(field, *head, options, gdal);
        if (!placed) return placed;
    }
    return foundation::success();
}

Result<HeightField> importDem(const std::filesystem::path& file, const DemImportOptions& options)
{
    return importDems({&file, 1}, options);
}

Result<HeightField> importDems(std::span<const std::filesystem::path> files, const DemImportOptions& options)
{
    std::optional<GridPlace> place;
    return importDems(files, options, place);
}

Result<HeightField> importDems(std::span<const std::filesystem::path> files, const DemImportOptions& options,
                               std::optional<GridPlace>& place)
{
    try
    {
        return import(files, options, place);
    }
    catch (const std::bad_alloc&)
    {
        return Error{namesOf(files), "does not fit into memory",
                     "cut a part out with gdal_translate -srcwin"};
    }
}

} // namespace osgTerrainROAM::core
