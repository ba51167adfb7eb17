// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

namespace osgTerrainROAM::core
{

/// What a raster's heights are counted from.
enum class VerticalDatum
{
    automatic, ///< ellipsoidal if the file says so, else EGM96 (SRTM, DTED and most GeoTIFFs)
    egm96,
    ellipsoid,
};

/// What becomes of samples that a raster does not have.
enum class Voids
{
    fill, ///< by a smooth surface from their rims
    keep, ///< as holes in the ground
};

struct DemImportOptions
{
    std::optional<double> spacingM; ///< sample distance of a raster without georeference; overrides none
    VerticalDatum verticalDatum = VerticalDatum::automatic;
    Voids voids = Voids::fill;
};

/// Reads any single-band elevation raster that GDAL opens: SRTM .hgt (also zipped and gzipped), GeoTIFF in
/// geographic or projected coordinates, DTED, ESRI and GRASS ASCII grids, PNG; 8-bit, Int16, Float32 and others;
/// south-up or north-up; with nodata. Every sample is kept; nothing is resampled.
/// Voids (nodata, NaN, GRASS nulls, heights outside -12000 to 9000 m) are filled by a spline in tension from their
/// rims, within the rims' range, and reported. Feet become metres.
/// A grid without a named reference system is a plane with its own cell size, unless its numbers look like degrees
/// (cells of whole arc seconds or whole parts of one, within ±360° and ±90°, not beginning at zero): then WGS84.
/// Errors: missing or unreadable file, several bands, rotated grid, no georeference and no spacing, all void.
/// Nothing is written beside the input.
foundation::Result<HeightField> importDem(const std::filesystem::path& file,
                                          const DemImportOptions& options = {});

/// Joins several such rasters, of any extents, spacings and coordinate reference systems, on the grid of the finest; where that
/// would be more than 2^26 samples, on a coarser one, and finer data become denser parts of it (HeightField::parts). That one's
/// samples are kept as they are; coarser data are interpolated, and bent where they meet finer, over four of their own samples, so
/// that there is one height along each seam. What no raster reaches is a hole (HeightField::mask).
/// `files`: at least one. Errors: as importDem of each; no georeference; different vertical datums; a plane among rasters on the
/// Earth; more than 2^26 samples all the same.
foundation::Result<HeightField> importDems(std::span<const std::filesystem::path> files,
                                           const DemImportOptions& options = {});

} // namespace osgTerrainROAM::core
