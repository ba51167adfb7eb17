// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <foundation/Heights.h>
#include <gtest/gtest.h>

#include "MadeStreets.h"
#include "TestFolder.h"
#include "worldmaking/check/CrossingCheck.h"
#include "worldmaking/map/ReadLand.h"

/// Small made maps of ways that cross.
namespace madecrossings
{

using namespace worldmaking;
using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;
using osgRoads::core::StructureKind;

using Height = std::function<double(double eastM, double northM)>;

inline double level(double, double)
{
    return 200.0;
}

/// The streets and railways of a made map, and what the check of worlds says of them.
struct MadeCrossing
{
    Streets streets;
    foundation::HeightInPlan groundM;

    const Road& road(const std::string& name) const
    {
        const auto& roads = streets.network.roads;
        const auto found =
            std::find_if(roads.begin(), roads.end(), [&](const Road& r) { return r.name == name; });
        EXPECT_NE(found, roads.end()) << name;
        return *found;
    }

    std::vector<RailLine> rails() const
    {
        std::vector<RailLine> lines;
        for (const Track& track : streets.tracks)
        {
            lines.emplace_back();
            lines.back().isTube = track.place == StreetPlace::tunnel;
            for (std::size_t i = 0; i < track.points.size(); ++i)
                lines.back().points.emplace_back(track.points[i], track.heightsM[i]);
        }
        for (const Footbridge& bridge : streets.footbridges)
        {
            if (bridge.isRamp) continue;
            lines.emplace_back();
            lines.back().isFootbridge = true;
            for (std::size_t i = 0; i < bridge.points.size(); ++i)
                lines.back().points.emplace_back(bridge.points[i], bridge.heightsM[i]);
        }
        return lines;
    }

    std::vector<CrossingFault> faults() const { return faultsWith(rails()); }
    std::vector<CrossingFault> faultsWith(const std::vector<RailLine>& lines) const
    {
        const PlacedNetwork placed(std::make_shared<osgRoads::core::RoadNetwork>(streets.network));
        return crossingFaults(&placed, lines, groundM);
    }
};

inline MadeCrossing crossingOf(const MadeMap& map, const Height& heightM = level)
{
    const testsupport::TestFolder folder("crossings");
    const auto file = folder / "made.osm";
    std::ofstream(file) << map.text();
    const auto land = readLand(file, MapBounds());
    EXPECT_TRUE(land) << (land ? "" : land.error().message());
    const auto read = parseOsm(map.text(), "osm", "made.osm");
    const double perDegree =
        MadeMap::kMetresPerDegree * std::cos(MadeMap::kLatitudeDeg * 3.14159265358979 / 180.0);
    const auto ground = [&](double latitudeDeg, double longitudeDeg) -> std::optional<double>
    {
        return heightM((longitudeDeg - MadeMap::kLongitudeDeg) * perDegree,
                       (latitudeDeg - MadeMap::kLatitudeDeg) * MadeMap::kMetresPerDegree);
    };
    auto streets = buildStreets(*read, ground, "made.osm", &*land);
    EXPECT_TRUE(streets) << (streets ? "" : streets.error().message());
    return {std::move(*streets), [](const glm::dvec2&) { return std::optional(200.0); }};
}

/// A street from west to east, of which the middle 60 m have tags of their own.
inline void addStreet(MadeMap& map, double northM, const char* name,
                      std::initializer_list<std::pair<const char*, const char*>> middle, double halfM = 30.0)
{
    const int a = map.node(-400, northM), b = map.node(-halfM, northM), c = map.node(halfM, northM),
              d = map.node(400, northM);
    map.way({a, b}, {{"highway", "secondary"}, {"name", name}});
    map.way({b, c}, middle);
    map.way({c, d}, {{"highway", "secondary"}});
}

inline void addAcross(MadeMap& map, double eastM,
                      std::initializer_list<std::pair<const char*, const char*>> tags)
{
    map.way({map.node(eastM, -300), map.node(eastM, 300)}, tags);
}

} // namespace madecrossings
