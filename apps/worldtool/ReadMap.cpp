// SPDX-License-Identifier: Apache-2.0
#include "worldtool/ReadMap.h"

#include <algorithm>
#include <string>

#include "worldmaking/map/ClipShapes.h"
#include "worldmaking/map/ReadLand.h"
#include "worldmaking/map/ReadOsm.h"

namespace worldtool
{

namespace
{

using worldmaking::MapBounds;

/// Leaves out streets of which no node lies within bounds.
void cutTo(const MapBounds& bounds, worldmaking::StreetMap& streets)
{
    std::erase_if(streets.ways,
                  [&](const worldmaking::MapWay& way)
                  {
                      return std::none_of(way.nodes.begin(), way.nodes.end(),
                                          [&](std::uint32_t node)
                                          {
                                              const auto& at = streets.nodes[node];
                                              return bounds.contains({at.longitudeDeg, at.latitudeDeg});
                                          });
                  });
}

bool isOsm(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    return name.ends_with(".osm") || name.ends_with(".osm.gz") || name.ends_with(".pbf") ||
           name.ends_with(".osm.bz2");
}

} // namespace

bool WholeMap::isOn(const EarthGround& ground) const
{
    const auto isThere = [&](const glm::dvec2& place)
    { return ground.heightM(place.y, place.x).has_value(); };
    return std::any_of(land.shapes.begin(), land.shapes.end(),
                       [&](const worldmaking::LandShape& shape)
                       {
                           return std::any_of(shape.paths.begin(), shape.paths.end(),
                                              [&](const auto& path)
                                              { return std::any_of(path.begin(), path.end(), isThere); });
                       });
}

foundation::Result<WholeMap> readMap(const std::filesystem::path& file, const MapBounds& bounds,
                                     const MapBounds& ground)
{
    constexpr double kMarginDeg = 0.05; // woods and waters go on to the edge of what is seen

    WholeMap map;
    if (isOsm(file))
    {
        auto streets = worldmaking::readOsm(file);
        if (!streets) return streets.error();
        map.streets = std::move(*streets);
        cutTo(bounds, map.streets);
    }
    auto land = worldmaking::readLand(file, bounds);
    if (!land) return land.error();
    map.land = std::move(*land);
    worldmaking::clipTo(ground, kMarginDeg, map.land);
    if (!isOsm(file)) map.streets = worldmaking::streetsOf(map.land);
    return map;
}

} // namespace worldtool
