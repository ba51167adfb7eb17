// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include <viewlod/Result.h>

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

struct DemImportOptions
{
    std::optional<double> spacingM; ///< sample distance of a raster without georeference; overrides none
    VerticalDatum verticalDatum = VerticalDatum::automatic;
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
viewlod::Result<HeightField> importDem(const std::filesystem::path& file,
                                       const DemImportOptions& options = {});

} // namespace osgTerrainROAM::core
