// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <foundation/KeptFrom.h>
#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// A point or an area of a map with all its attributes. Frame: the tile's local east and north, metres.
struct MapShape
{
    std::int64_t id = 0;   ///< its number in the source
    glm::dvec2 point{0.0}; ///< of a point
    std::vector<std::vector<glm::dvec2>>
        rings; ///< of an area: the outer one, then its holes; none repeats its first point
    std::map<std::string, std::string, std::less<>> tags;

    bool isArea() const { return !rings.empty(); }
};

/// A line of a map with all its attributes. Frame: the tile's local east and north, metres.
struct MapLine
{
    std::int64_t id = 0; ///< its number in the source
    std::vector<glm::dvec2> points;
    std::map<std::string, std::string, std::less<>> tags;
};

/// The points, areas and lines of a source.
struct ShapeSet
{
    std::vector<MapShape> shapes; ///< points and areas
    std::vector<MapLine> linear;  ///< as many as `lines`, less those beyond the tile or without two points
    std::size_t lines = 0, outside = 0, invalid = 0;
    std::vector<std::string> notes{}; ///< what GDAL warned of, one line each
};

/// Reads the points, areas and lines of any vector source that GDAL's OGR opens, with all attributes (those
/// of OGR's other_tags, too). Each polygon of several is a shape of its own. Coordinates are put on the
/// tile's ground, as importFeatures() does.
/// Errors: as importFeatures(), but for a source that has none of them. Cost: about 3 µs a vertex. Threads:
/// any.
/// `kept`: what follows from the tile (RoamTile::mark()); what a GeoPackage held is found there at the second
/// import.
foundation::Result<ShapeSet> importShapes(const std::filesystem::path& source, const PlacedTile& tile,
                                          const foundation::KeptFrom& kept = {});

} // namespace osgTerrainROAM::core
