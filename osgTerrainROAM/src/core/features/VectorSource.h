// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <foundation/Result.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "../heightfield/GdalSession.h"

namespace osgTerrainROAM::core
{

struct DatasetCloser
{
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;
using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

/// Opens a vector source that is to be laid on a tile. Errors: a planar tile with georeference; no such file; no format of OGR.
foundation::Result<DatasetPtr> openVectorSource(const std::filesystem::path& source, const PlacedTile& tile,
                                                GdalSession& gdal);

/// Names a layer in messages.
std::string placeOf(const std::filesystem::path& source, OGRLayer& layer);

/// From a layer's coordinates to WGS84; null on planar tiles. Errors: no coordinate system, or one that cannot be related.
foundation::Result<Transformation> transformationOf(const std::filesystem::path& source, OGRLayer& layer,
                                                    const PlacedTile& tile);

/// Transforms a vertex to degrees east and north (planar: leaves it). Returns false where there is no such place.
bool transform(glm::dvec2& vertex, OGRCoordinateTransformation* toWgs84);

/// Returns the value of an attribute, also of one in OGR's other_tags; empty where there is none.
std::string attributeOf(OGRFeature& feature, const char* name);

/// Returns the points of a curve; a ring without the last one, which repeats the first.
std::vector<glm::dvec2> pathOf(const OGRSimpleCurve& curve, bool ring);

/// The error of a layer that GDAL could not read to its end.
foundation::Error damageOf(const std::filesystem::path& source, OGRLayer& layer, const GdalSession& gdal);

} // namespace osgTerrainROAM::core
