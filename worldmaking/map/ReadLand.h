// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "worldmaking/map/LandMap.h"

namespace worldmaking
{

/// Reads all points, lines and areas of a map with their tags, through GDAL's OGR: OpenStreetMap extracts
/// (.osm, .osm.gz, .osm.pbf), GeoPackage, GeoJSON, shapefile. Multipolygons become an area for each outline.
/// Geofabrik's `fclass` becomes the tag it stands for (tagsOfClass()). Things wholly outside `bounds` are
/// left out.
/// Errors: a file that cannot be opened or is damaged; a layer without coordinate system.
/// Memory: about 150 B a shape and 16 B a point. Cost: some 3 s for 500 000 nodes.
foundation::Result<LandMap> readLand(const std::filesystem::path& file, const MapBounds& bounds = {});

/// Turns Geofabrik's attributes (fclass, bridge = T, oneway = F …) into tags of OpenStreetMap; other tags
/// stay.
/// Source: Geofabrik, *OpenStreetMap Data in Layered GIS Format*, 0.7.12.
void tagsOfClass(LandShape& shape);

/// Makes a street map of the lines of a map with the key `highway`: points at the same place become one node.
StreetMap streetsOf(const LandMap& land);

} // namespace worldmaking
