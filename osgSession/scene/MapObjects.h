// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "scenery/models/Catalogue.h"

namespace trainer
{

/// A generated model of map objects.
struct MapModel
{
    std::uint64_t kind = 0; ///< scenery::models::Kind
    std::uint64_t seed = 0;

    bool operator==(const MapModel&) const = default;
};

/// A point of a map where a model stands upright. Frame: the scene's. Units: metres, radians.
struct MapObject
{
    glm::dvec3 position{0.0}; ///< on the ground
    double headingRad = 0.0;  ///< of its forward axis, counter-clockwise from east
    double scale = 1.0;
    std::uint64_t model = 0; ///< of MapObjects::models

    bool operator==(const MapObject&) const = default;
};

/// The points of a source at which generated models stand.
struct MapObjects
{
    std::vector<MapModel> models; ///< in the order of their first objects
    std::vector<MapObject> objects;
    std::uint64_t unused = 0;       ///< of no known kind, or beyond the ground
    std::vector<std::string> notes; ///< what GDAL warned of, one line each

    bool operator==(const MapObjects&) const = default;
};

/// Reads the points of a source of a world and stands them on the ground, which must follow from the tile
/// alone, or finds where they stood the last time: half a million in some hundredths of a second.
/// Errors: those of importShapes().
foundation::Result<MapObjects> readMapObjects(const std::filesystem::path& source,
                                              const osgTerrainROAM::core::RoamTile& tile,
                                              const foundation::HeightInPlan& ground);

/// Returns objects as bytes for mapObjectsIn().
std::string bytesOf(const MapObjects& objects);

/// Absent: bytesOf() did not write them, or a model that is not generated stands somewhere.
std::optional<MapObjects> mapObjectsIn(std::string_view bytes);

} // namespace trainer
