// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "MadeMap.h"
#include "worldmaking/map/ReadOsm.h"
#include "worldmaking/streets/BuildStreets.h"

/// The streets of a made map on a made ground. `heightM`: of metres east and north of the map's zero.
template<class Height>
worldmaking::Streets streetsOf(const MadeMap& map, const Height& heightM)
{
    const auto read = worldmaking::parseOsm(map.text(), "osm", "made.osm");
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    const auto ground = [&](double latitudeDeg, double longitudeDeg) -> std::optional<double>
    {
        const double eastM = (longitudeDeg - MadeMap::kLongitudeDeg) * MadeMap::kMetresPerDegree *
                             std::cos(MadeMap::kLatitudeDeg * 3.14159265358979 / 180.0);
        return heightM(eastM, (latitudeDeg - MadeMap::kLatitudeDeg) * MadeMap::kMetresPerDegree);
    };
    auto streets = worldmaking::buildStreets(*read, ground, "made.osm");
    EXPECT_TRUE(streets) << (streets ? "" : streets.error().message());
    return std::move(*streets);
}

/// The steepest grade of all roads of a network, metres per metre.
inline double steepestOf(const osgRoads::core::RoadNetwork& network)
{
    double steepest = 0.0;
    for (const auto& road : network.roads)
        for (int i = 0; i <= 200; ++i)
            steepest = std::max(steepest, std::fabs(road.elevation.slope(road.length * i / 200.0)));
    return steepest;
}
