// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/LayRoads.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>

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

GroundFeature ribbon(double widthM)
{
    GroundFeature feature;
    feature.style.widthM = widthM;
    feature.style.marked = false;
    feature.paths.emplace_back();
    return feature;
}

} // namespace

foundation::Result<SceneRoads> layRoads(const osgTerrainROAM::core::RoamFile& description,
                                        const std::shared_ptr<osgTerrainROAM::core::RoamTile>& tile)
{
    if (description.roads.empty()) return SceneRoads{};
    RoadsRequest request{description.roads, std::nullopt,
                         description.roadsOnGround ? RoadHeights::ground : RoadHeights::file};
    if (const auto& origin = description.roadsOrigin)
        request.origin = RoadOrigin{origin->latitudeDeg, origin->longitudeDeg, origin->headingDeg};
    auto roads = placeRoads(request, tile->tile);
    if (!roads) return roads;
    osgTerrainROAM::core::TileEditor editor(tile);
    if (const auto cut = cutRoads(editor, *roads->placed); !cut) return cut.error();
    return roads;
}

std::vector<GroundFeature> farRoads(const osgRoads::core::PlacedNetwork& roads)
{
    std::vector<GroundFeature> features;
    for (int i = 0; i < static_cast<int>(roads.network().roads.size()); ++i)
    {
        const Road& road = roads.road(i);
        if (!road.isUsable) continue;
        GroundFeature current = ribbon(0.0);
        const auto finish = [&]
        {
            if (current.paths.front().size() > 1) features.push_back(current);
            current = ribbon(0.0);
        };
        for (const double s : osgRoads::core::evenStations(road.length, kRibbonStepM))
        {
            const Carriageway lanes = carriagewayAt(road, s);
            const bool isOnGround = lanes.widthM > 1.0 && !osgRoads::core::structureAt(road, s);
            if (isOnGround) current.paths.front().emplace_back(roads.surfacePoint(i, s, lanes.middleT));
            if (!isOnGround || std::abs(current.style.widthM - lanes.widthM) > 0.5)
            {
                const auto last = current.paths.front();
                finish();
                if (isOnGround) current.paths.front().push_back(last.back()); // the next one begins here
            }
            current.style.widthM = lanes.widthM;
        }
        finish();
    }
    return features;
}

} // namespace scenery
