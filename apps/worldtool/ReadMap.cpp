// SPDX-License-Identifier: Apache-2.0
#include "worldtool/ReadMap.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "worldmaking/map/ClipShapes.h"
#include "worldmaking/map/JoinLand.h"
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

/// The file that several are joined to. It goes with this object, and what an ended build left.
class JoinedFile
{
public:
    explicit JoinedFile(const std::filesystem::path& folder) : path(folder / "map.part.osm.pbf") { remove(); }
    ~JoinedFile() { remove(); }
    JoinedFile(const JoinedFile&) = delete;
    JoinedFile& operator=(const JoinedFile&) = delete;

    const std::filesystem::path path;

private:
    void remove() const
    {
        std::error_code failed;
        std::vector<std::filesystem::path> left;
        for (auto entry = std::filesystem::directory_iterator(path.parent_path(), failed);
             !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed))
            if (entry->path().filename().string().starts_with(path.filename().string()))
                left.push_back(entry->path());
        for (const auto& file : left)
            std::filesystem::remove(file, failed);
    }
};

foundation::Outcome addOsm(const std::vector<worldmaking::MapSource>& sources,
                           const std::filesystem::path& folder, const MapBounds& bounds, WholeMap& map)
{
    const JoinedFile joined(folder);
    const auto file = worldmaking::joinOsm(sources, joined.path, map.joined);
    if (!file) return file.error();
    auto streets = worldmaking::readOsm(*file);
    if (!streets) return streets.error();
    map.streets = std::move(*streets);
    cutTo(bounds, map.streets);
    auto land = worldmaking::readLand(*file, bounds);
    if (!land) return land.error();
    map.land = std::move(*land);
    return foundation::success();
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

foundation::Result<WholeMap> readMap(const std::vector<worldmaking::MapSource>& sources,
                                     const std::filesystem::path& folder, const MapBounds& bounds,
                                     const MapBounds& ground)
{
    constexpr double kMarginDeg = 0.05; // woods and waters go on to the edge of what is seen

    WholeMap map;
    std::vector<worldmaking::MapSource> osm, others;
    for (const auto& source : sources)
        (source.isOsm ? osm : others).push_back(source);
    if (!osm.empty())
        if (const auto added = addOsm(osm, folder, bounds, map); !added) return added.error();
    worldmaking::LandMap more;
    for (const auto& source : others)
    {
        auto land = worldmaking::readLand(source.file, bounds);
        if (!land) return land.error();
        map.joined.repeated += worldmaking::joinLand(more, std::move(*land));
        ++map.joined.files;
    }
    worldmaking::clipTo(ground, kMarginDeg, map.land);
    worldmaking::clipTo(ground, kMarginDeg, more);
    worldmaking::joinStreets(map.streets, worldmaking::streetsOf(more));
    (void)worldmaking::joinLand(map.land, std::move(more));
    return map;
}

} // namespace worldtool
