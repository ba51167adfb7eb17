// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include "worldmaking/map/JoinOsm.h"
#include "worldmaking/map/LandMap.h"
#include "worldtool/EarthGround.h"

namespace worldtool
{

/// A map: its streets with nodes and rules of turns, and everything as shapes.
struct WholeMap
{
    worldmaking::StreetMap streets;
    worldmaking::LandMap land;
    worldmaking::JoinReport joined; ///< with what other formats had twice

    /// Whether any of its shapes lies on the ground. (Streets are shapes, too.)
    bool isOn(const EarthGround& ground) const;
};

/// Reads a map within bounds, and its woods and waters a little beyond the ground. A map may have no street.
/// Files of OpenStreetMap become one first, where they are several or not plain, in `folder`, for as long as
/// they are read. `ground`: the rectangle of the elevation data. Errors: those of joinOsm(), readOsm() and
/// readLand().
foundation::Result<WholeMap> readMap(const std::vector<worldmaking::MapSource>& sources,
                                     const std::filesystem::path& folder,
                                     const worldmaking::MapBounds& bounds,
                                     const worldmaking::MapBounds& ground);

} // namespace worldtool
