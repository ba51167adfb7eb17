// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

/// A road along x through a ridge, with a tunnel: 840 m from x = 60 at y = 480, 5 m high, two lanes of 3.5 m.
namespace tunnelscene
{

constexpr double kRoadX = 60.0, kRoadY = 480.0, kRoadM = 5.0, kLengthM = 840.0;
constexpr double kPortalX = 340.0,
                 kTunnelM = 280.0; ///< the ridge is 17 m above the sea at both portals, 64 m in the middle

inline std::shared_ptr<const osgRoads::core::PlacedNetwork> road(bool hasTunnel = true)
{
    const auto number = [](double value) { return std::to_string(value); };
    const std::string lane = R"(<width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>)";
    const std::string tunnel = R"(<objects><tunnel id="t" name="ridge" type="standard" s=")" +
                               number(kPortalX - kRoadX) + R"(" length=")" + number(kTunnelM) +
                               R"("/></objects>)";
    auto read = osgRoads::core::parseNetwork(
        R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="840" junction="-1">
<planView><geometry s="0" x="60" y="480" hdg="0" length="840"><line/></geometry></planView>
<elevationProfile><elevation s="0" a=")" +
            number(kRoadM) + R"(" b="0" c="0" d="0"/></elevationProfile>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false">)" +
            lane + R"(</left><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false">)" +
            lane + "</right></laneSection></lanes>" + (hasTunnel ? tunnel : "") + "</road></OpenDRIVE>",
        "ridge.xodr");
    if (!read) return nullptr;
    return std::make_shared<const osgRoads::core::PlacedNetwork>(
        std::make_shared<osgRoads::core::RoadNetwork>(std::move(read->network)));
}

/// A ridge across the road, 30 m a sample, with room for samples 1.9 m apart; not cut yet.
inline std::shared_ptr<osgTerrainROAM::core::RoamTile> ridge()
{
    using namespace osgTerrainROAM::core;
    HeightField field;
    field.name = "ridge";
    field.columns = field.rows = 33;
    field.spacingEastM = field.spacingNorthM = 30.0;
    for (int row = 0; row < field.rows; ++row)
        for (int column = 0; column < field.columns; ++column)
        {
            const double away = (30.0 * column - 480.0) / 80.0;
            const double height = 4.0 + 60.0 * std::exp(-0.5 * away * away) + 0.05 * (row - 16);
            field.heightsM.push_back(static_cast<float>(std::floor(height * 64.0) / 64.0));
        }
    return std::make_shared<RoamTile>(
        PlacedTile(std::move(field), PlacedTileOptions{.placement = Placement::planar, .gridExponent = 4}));
}

} // namespace tunnelscene
