// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/LayRoads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <foundation/MappedFile.h>
#include <foundation/Threads.h>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgRoads/core/surface/RoadMeshBytes.h>
#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/edit/ShapeGround.h>

#include "scenery/roads/CutRoads.h"

namespace scenery
{

namespace
{

using osgRoads::core::LaneSpan;
using osgRoads::core::Road;
using osgTerrainROAM::core::GroundFeature;

constexpr double kRibbonStepM = 10.0;

/// The t of the middle of the lanes for cars, and their width.
struct Carriageway
{
    double middleT = 0.0, widthM = 0.0;
};

Carriageway carriagewayAt(const Road& road, double s)
{
    const auto* section = osgRoads::core::sectionAt(road, s);
    if (!section) return {};
    double right = 1e9, left = -1e9;
    const auto take = [&](const LaneSpan& span)
    {
        if (!osgRoads::core::isForCars(span.lane->type)) return true;
        right = std::min({right, span.innerT, span.outerT});
        left = std::max({left, span.innerT, span.outerT});
        return true;
    };
    for (const int sign : {1, -1})
        osgRoads::core::forLanesOutwards(road, *section, sign, s, take);
    return left > right ? Carriageway{0.5 * (left + right), left - right} : Carriageway{};
}

/// A stretch of a road.
struct Stretch
{
    double from = 0.0, to = 0.0;
};

/// Returns the stretches of a road that lie on the ground. Where a ribbon ends in the open, its round end
/// must not reach beyond the road's: it is shorter by half its width.
std::vector<Stretch> stretchesOnGround(const Road& road)
{
    std::vector<Stretch> covered;
    for (const auto& structure : road.structures)
        covered.push_back({structure.s, structure.s + structure.length});
    std::sort(covered.begin(), covered.end(),
              [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
    covered.push_back({road.length, road.length});
    std::vector<Stretch> stretches;
    double from = 0.0;
    for (const Stretch& next : covered)
    {
        const bool goesOnBefore = from <= 0.0 && road.predecessor;
        const bool goesOnAfter = next.from >= road.length && road.successor;
        const double to = std::min(next.from, road.length);
        const Stretch stretch{goesOnBefore ? from : from + 0.5 * carriagewayAt(road, from).widthM,
                              goesOnAfter ? to : to - 0.5 * carriagewayAt(road, to).widthM};
        if (stretch.to > stretch.from) stretches.push_back(stretch);
        from = std::max(from, next.to);
    }
    return stretches;
}

GroundFeature ribbon(double widthM)
{
    GroundFeature feature;
    feature.style.widthM = widthM;
    feature.style.marked = false;
    feature.paths.emplace_back();
    return feature;
}

/// Adds the ribbons of a stretch of a road: one for each width.
void addRibbons(const osgRoads::core::PlacedNetwork& roads, int road, const Stretch& stretch,
                std::vector<GroundFeature>& features)
{
    GroundFeature current = ribbon(0.0);
    const auto finish = [&]
    {
        if (current.paths.front().size() > 1) features.push_back(current);
        current = ribbon(0.0);
    };
    for (const double along : osgRoads::core::evenStations(stretch.to - stretch.from, kRibbonStepM))
    {
        const double s = stretch.from + along;
        const Carriageway lanes = carriagewayAt(roads.road(road), s);
        const bool isRoad = lanes.widthM > 1.0;
        if (isRoad) current.paths.front().emplace_back(roads.surfacePoint(road, s, lanes.middleT));
        if (!isRoad || std::abs(current.style.widthM - lanes.widthM) > 0.5)
        {
            const auto last = current.paths.front();
            finish();
            if (isRoad) current.paths.front().push_back(last.back()); // the next one begins here
        }
        current.style.widthM = lanes.widthM;
    }
    finish();
}

/// The earthworks of a terrain that have shores.
foundation::Result<osgTerrainROAM::core::Earthworks>
waterOf(const osgTerrainROAM::core::RoamFile& description, const osgTerrainROAM::core::PlacedTile& tile)
{
    std::vector<osgTerrainROAM::core::Earthwork> works;
    for (const auto& source : description.earthworks)
    {
        auto read = osgTerrainROAM::core::importEarthworks(source, tile);
        if (!read) return read.error();
        for (auto& work : read->works)
            if (work.riseM > 0.0) works.push_back(std::move(work));
    }
    return osgTerrainROAM::core::Earthworks(works, 0.0,
                                            [](const glm::dvec2&) { return std::optional<double>(); });
}

} // namespace

namespace
{

/// layRoads() of a network that has been read.
foundation::Result<SceneRoads> layRead(RoadsFile read, const osgTerrainROAM::core::RoamFile& description,
                                       const std::shared_ptr<osgTerrainROAM::core::RoamTile>& tile)
{
    RoadsRequest request{description.roads, std::nullopt,
                         description.roadsOnGround ? RoadHeights::ground : RoadHeights::file};
    if (const auto& origin = description.roadsOrigin)
        request.origin = RoadOrigin{origin->latitudeDeg, origin->longitudeDeg, origin->headingDeg};
    auto roads = placeRoads(request, std::move(read), tile->tile);
    if (!roads || !description.edits.empty()) return roads;
    const auto water = waterOf(description, tile->tile);
    if (!water) return water.error();
    osgTerrainROAM::core::TileEditor editor(tile);
    if (const auto cut = cutRoads(editor, *roads->placed, {}, &*water); !cut) return cut.error();
    return roads;
}

} // namespace

foundation::Result<SceneRoads> layRoads(const osgTerrainROAM::core::RoamFile& description,
                                        const std::shared_ptr<osgTerrainROAM::core::RoamTile>& tile)
{
    if (description.roads.empty()) return SceneRoads{};
    auto read = readRoads(description.roads);
    return read ? layRead(std::move(*read), description, tile) : read.error();
}

foundation::Result<RoadTile> loadRoadTile(const osgTerrainROAM::core::RoamFile& description,
                                          const foundation::KeptResults* kept)
{
    std::optional<foundation::Result<RoadsFile>> read;
    foundation::Threads beside;
    if (!description.roads.empty()) beside.run([&] { read.emplace(readRoads(description.roads)); });
    const auto tile = osgTerrainROAM::core::loadRoamTile(description, kept);
    beside.join();
    if (!tile) return tile.error();
    if (!read) return RoadTile{*tile, {}};
    if (!*read) return read->error();
    auto roads = layRead(std::move(**read), description, *tile);
    if (!roads) return roads.error();
    return RoadTile{*tile, std::move(*roads)};
}

std::optional<foundation::ContentMark> markOfRoads(const osgTerrainROAM::core::RoamFile& description)
{
    const auto file = foundation::MappedFile::open(description.roads);
    if (!file) return std::nullopt;
    file->fetchAll();
    foundation::ContentMark mark;
    mark.add(file->text()).addWord(description.roadsOnGround ? 1U : 0U);
    if (const auto& origin = description.roadsOrigin)
        mark.add(std::vector<double>{origin->latitudeDeg, origin->longitudeDeg, origin->headingDeg});
    return mark;
}

std::shared_ptr<const osgRoads::core::PagedRoadMesh>
roadMeshOf(const SceneRoads& roads, const std::optional<foundation::ContentMark>& mark,
           const foundation::KeptFrom& kept)
{
    using osgRoads::core::PagedRoadMesh;
    using Mesh = std::shared_ptr<const PagedRoadMesh>;
    const auto make = [&]() -> Mesh
    {
        return std::make_shared<const PagedRoadMesh>(
            std::make_shared<const osgRoads::core::RoadMesh>(osgRoads::core::buildRoadMesh(
                *roads.placed, osgRoads::core::meshSettingsFor(roads.placed->network()))));
    };
    const auto read = [](std::string_view bytes) -> std::optional<Mesh>
    {
        const auto packed = std::make_shared<const std::string>(bytes);
        auto mesh = PagedRoadMesh::in(*packed, packed);
        return mesh ? std::optional<Mesh>(std::make_shared<const PagedRoadMesh>(*std::move(mesh)))
                    : std::nullopt;
    };
    if (!mark) return make();
    return kept.findOrMake("roads", *mark, read, make,
                           [](const Mesh& mesh, std::uintmax_t mostBytes)
                           { return osgRoads::core::bytesOf(mesh->outline(), mostBytes); });
}

std::vector<GroundFeature> farRoads(const osgRoads::core::PlacedNetwork& roads)
{
    std::vector<GroundFeature> features;
    for (int i = 0; i < static_cast<int>(roads.network().roads.size()); ++i)
        if (roads.road(i).isUsable)
            for (const Stretch& stretch : stretchesOnGround(roads.road(i)))
                addRibbons(roads, i, stretch, features);
    return features;
}

} // namespace scenery
