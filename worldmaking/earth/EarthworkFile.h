// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/edit/Earthworks.h>

#include "worldmaking/map/MapPlane.h"

namespace worldmaking
{

/// Writes earthworks as a GeoPackage that `earthworks` of a .roam file reads
/// (osgTerrainROAM/core/edit/ShapeGround.h), in their order.
/// Errors: as MapFile::finish().
foundation::Outcome writeEarthworks(std::span<const osgTerrainROAM::core::Earthwork> works,
                                    const MapPlane& plane, const std::filesystem::path& file);

} // namespace worldmaking
