// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <ogr_geometry.h>

#include "worldmaking/map/LandMap.h"

namespace worldmaking
{

/// Makes GDAL's geometry of a line or an area; an area that crosses itself is mended. Null: it cannot be.
std::unique_ptr<OGRGeometry> geometryOf(const LandShape& shape);

/// Appends what a geometry consists of, piece by piece, with the id, the form and the tags of a shape; pieces
/// of another form are left out.
void addPieces(const OGRGeometry& geometry, const LandShape& like, std::vector<LandShape>& pieces);

} // namespace worldmaking
