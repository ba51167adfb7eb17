// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/GridPlace.h>

#include "GdalSession.h"
#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Gives a field its net and its spacing from the raster's georeference; without one, the field stays planar.
/// Of the field its name, columns and rows are known; heights are not looked at.
/// Errors: no georeference and no spacing; a georeference that cannot be used.
foundation::Outcome placeField(HeightField& field, Raster& raster, const DemImportOptions& options,
                               GdalSession& gdal);

/// Where the samples of a raster that placeField() has looked at lie; nothing without a georeference.
std::optional<GridPlace> placeOf(const Raster& raster);

} // namespace osgTerrainROAM::core
