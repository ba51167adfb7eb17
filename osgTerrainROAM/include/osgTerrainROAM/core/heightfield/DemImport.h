// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

namespace osgTerrainROAM::core
{

/// The vertical datum of a raster's heights.
enum class VerticalDatum
{
    automatic, ///< ellipsoidal if the file says so, else EGM96 (SRTM, DTED and most GeoTIFFs)
    egm96,
    ellipsoid,
};

/// The treatment of samples that a raster does not have.
enum class Voids
{
    fill, ///< a smooth surface from their rims fills them
    keep, ///< they become holes in the ground
};

struct DemImportOptions
{
    std::optional<double> spacingM; ///< sample distance of a raster without georeference; overrides none
    VerticalDatum verticalDatum = VerticalDatum::automatic;
    Voids voids = Voids::fill;
};

/// Reads any single-band elevation raster that GDAL opens: SRTM .hgt (also zipped and gzipped), GeoTIFF in
/// geographic or projected coordinates, DTED, ESRI and GRASS ASCII grids, PNG; 8-bit, Int16, Float32 and
/// others; south-up or north-up; with nodata. Every sample is kept; nothing is resampled. Voids (nodata, NaN,
/// GRASS nulls, heights outside -12000 to 9000 m) are filled by a spline in tension from their rims, within
/// the rims' range, and reported. Feet become metres. A grid without a named reference system is a plane with
/// its own cell size, unless its numbers look like degrees (cells of whole arc seconds or whole parts of one,
/// within ±360° and ±90°, not beginning at zero): then WGS84.
/// Errors: missing or unreadable file, several bands, rotated grid, no georeference and no spacing, all void.
/// Nothing is written beside the input.
foundation::Result<HeightField> importDem(const std::filesystem::path& file,
                                          const DemImportOptions& options = {});

/// Joins several such rasters, of any extents, spacings and coordinate reference systems, on the grid of the
/// finest raster; where that would have more than 2^26 samples, on a coarser grid, and finer data become its
/// dense parts (HeightField::parts). Samples on that grid are kept as they are. Coarser data are
/// interpolated, and blended over four of their own samples where they meet finer data, so that there is one
/// height along each seam. Points that no raster reaches are holes (HeightField::mask).
/// `files`: at least one. Errors: those of importDem for each; no georeference; different vertical datums; a
/// planar raster among georeferenced ones; more than 2^26 samples on every possible grid.
foundation::Result<HeightField> importDems(std::span<const std::filesystem::path> files,
                                           const DemImportOptions& options = {});

} // namespace osgTerrainROAM::core
