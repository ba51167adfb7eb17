// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include <foundation/Result.h>

#include "worldmaking/land/CoverRaster.h"
#include "worldmaking/land/Runways.h"
#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"

namespace worldmaking
{

/// What became of the things of a map that are painted on the ground.
struct LandReport
{
    std::size_t fields = 0, waters = 0, waterLines = 0, ways = 0, railways = 0, aprons = 0, runways = 0;
    std::size_t coverAreas = 0;
    double untaggedWoodsHa = 0.0; ///< of woods where the map says nothing
    double gardensHa = 0.0, yardsHa = 0.0;
    std::map<std::string, std::size_t> unused; ///< areas and lines by the tag that says what they are
};

/// Returns the class of an area of a map; nothing where its tags name none.
std::optional<Cover> coverOf(const Tags& tags);

/// Returns the part of the plane that the things of a map lie in, streets included; nothing where there are
/// none.
std::optional<MapBox> extentOf(const LandMap& map, const MapPlane& plane);

/// Paints the areas of a map, larger ones below smaller ones; water lies above all.
/// `limit`: the part of the plane to cover; absent: that of these areas.
CoverRaster coverRasterOf(const LandMap& map, const MapPlane& plane, const std::optional<MapBox>& limit,
                          LandReport& report);

/// Writes what is painted exactly, as a GeoPackage with the attribute `kind` that `features` of a .roam file
/// reads: fields, lakes, rivers, tracks and paths, railways, taxiways and aprons, runways. Covered waters and
/// ways in tunnels are left out.
/// Errors: as MapFile::finish().
foundation::Outcome writeGround(const LandMap& map, std::span<const Runway> runways,
                                const std::filesystem::path& file, LandReport& report);

} // namespace worldmaking
