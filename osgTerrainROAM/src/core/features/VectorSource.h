// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <ogrsf_frmts.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Takes a feature of a layer; the transformation to WGS84 is null on planar tiles.
using FeatureUse =
    std::function<foundation::Outcome(OGRFeature&, OGRLayer&, OGRCoordinateTransformation* toWgs84)>;

/// Reads the features of all layers of a vector source that is to be laid on a tile. Errors: a planar tile
/// with georeference; no such file; no format of OGR; a layer without a coordinate system, or with one that
/// cannot be related; one that is damaged; those of `use`, which end it.
/// Returns what GDAL warned of, one line each.
foundation::Result<std::vector<std::string>> forEachFeature(const std::filesystem::path& source,
                                                            const PlacedTile& tile, const FeatureUse& use);

/// Names a layer in messages.
std::string placeOf(const std::filesystem::path& source, OGRLayer& layer);

/// Transforms a vertex to degrees east and north (planar: leaves it). Returns false where there is no such
/// place.
bool transform(glm::dvec2& vertex, OGRCoordinateTransformation* toWgs84);

/// Returns the value of an attribute, also of one in OGR's other_tags; empty where there is none.
std::string attributeOf(OGRFeature& feature, const char* name);

/// Returns the points of a curve; a ring without the last one, which repeats the first.
std::vector<glm::dvec2> pathOf(const OGRSimpleCurve& curve, bool ring);

} // namespace osgTerrainROAM::core
