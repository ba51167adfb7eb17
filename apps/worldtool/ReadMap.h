// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "worldmaking/map/LandMap.h"
#include "worldtool/EarthGround.h"

namespace worldtool
{

/// A map: its streets with nodes and rules of turns, and everything as shapes.
struct WholeMap
{
    worldmaking::StreetMap streets;
    worldmaking::LandMap land;

    /// Whether any of its shapes lies on the ground. (Streets are shapes, too.)
    bool isOn(const EarthGround& ground) const;
};

/// Reads a map within bounds, and its woods and waters a little beyond the ground. A map may have no street.
/// `ground`: the rectangle of the elevation data. Errors: those of readOsm() and readLand().
foundation::Result<WholeMap> readMap(const std::filesystem::path& file, const worldmaking::MapBounds& bounds,
                                     const worldmaking::MapBounds& ground);

} // namespace worldtool
