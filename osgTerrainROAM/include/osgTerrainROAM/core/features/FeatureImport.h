// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/KeptFrom.h>
#include <foundation/Result.h>

#include <osgTerrainROAM/core/features/GroundFeature.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Reads roads, rivers, fields and runways from any vector source that GDAL's OGR opens (GeoPackage, GeoJSON,
/// shapefile, …), from all its layers. Its attributes tell what a feature is (FeatureTags.h): an explicit
/// `kind` and `width`, the tags of OpenStreetMap, or else the name of its layer.
/// Curved tiles: coordinates are transformed to WGS84 and put on the tile's ground; lines are divided into
/// pieces of at most 250 m, so that they follow the ground. Planar tiles without georeference: coordinates
/// are the tile's metres.
/// Errors: file missing, damaged or not a format of OGR; a layer without coordinate system; a planar tile
/// with georeference (its metres are not those of the source); nothing to paint. Invalid, unknown and
/// outlying features are left out and counted.
/// Cost: about 3 µs a vertex. Threads: any.
/// `kept`: what follows from the tile (RoamTile::mark()); what a GeoPackage held is found there at the second
/// import.
foundation::Result<FeatureSet> importFeatures(const std::filesystem::path& source, const PlacedTile& tile,
                                              const foundation::KeptFrom& kept = {});

} // namespace osgTerrainROAM::core
