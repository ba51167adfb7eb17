// SPDX-License-Identifier: Apache-2.0
// A land and things to put there, for tests.
#pragma once

#include <cmath>

#include "scenery/placement/PlaceScenery.h"
#include "scenery/placement/PlacementCheck.h"
#include "scenery/placement/ReadScenery.h"

namespace scenerytest
{

using namespace scenery;

/// Hills of 300 m and some bumps, a sea in the west, no data beyond 4 km.
inline Ground hills()
{
    Ground ground;
    ground.heightM = [](const glm::dvec2& plan) -> std::optional<double>
    {
        const double east = plan.x, north = plan.y;
        if (std::abs(east) > 4000.0 || std::abs(north) > 4000.0) return std::nullopt;
        return 60.0 + 0.03 * east + 40.0 * std::sin(east / 300.0) * std::cos(north / 350.0) +
               0.15 * std::sin(east / 9.0) * std::sin(north / 7.0);
    };
    ground.cover = [](double east, double) -> std::string_view { return east > 500.0 ? "forest" : "meadow"; };
    ground.seaLevelM = 0.0;
    return ground;
}

/// A description of all arrangements, and measures like those of generated models.
inline SceneryDescription village(std::uint32_t trees = 3000)
{
    const auto read = parseScenery(
        R"({"seed": 5, "fields": [
        {"name": "wood", "objects": [{"kind": "oak", "seeds": [1, 2]}, {"kind": "spruce"}], "count": )" +
            std::to_string(trees) + R"(, "crowding": 0.5, "scale": [0.8, 1.2],
         "where": {"circle": {"eastM": 0, "northM": 0, "radiusM": 2500}, "slopeDeg": [0, 20],
                   "patchM": 300, "patchShare": 0.6}},
        {"name": "village", "arrangement": "settlement", "objects": [{"kind": "family-house", "seeds": [1, 2, 3]}],
         "settlement": {"settlements": 2}, "where": {"circle": {"eastM": 0, "northM": 0, "radiusM": 2000}}},
        {"name": "cars", "arrangement": "parked", "beside": "village", "count": 30, "objects": [{"kind": "saloon"}],
         "where": {"circle": {"eastM": 0, "northM": 0, "radiusM": 2500}}},
        {"name": "orchard", "arrangement": "rows", "count": 200, "rows": {"rows": 6, "lengthM": 90},
         "objects": [{"kind": "bush"}], "where": {"pathDistanceM": [0, 600], "slopeDeg": [0, 10]}}
        ]})",
        "village.json");
    return read ? *read : SceneryDescription{};
}

inline std::vector<Measures> measuresFor(const SceneryDescription& description)
{
    std::vector<Measures> all;
    for (const SceneryObject& object : objectsOf(description))
        switch (*object.kind)
        {
        case scenery::models::Kind::familyHouse:
            all.push_back({8.0, 1.0, {-5.0, -4.5}, {5.0, 4.5}, Stance::upright, false});
            break;
        case scenery::models::Kind::saloon:
            all.push_back({2.4, 0.0, {-1.4, -0.8}, {1.4, 0.8}, Stance::tilted, false});
            break;
        default:
            all.push_back({5.0, 0.4, {-0.4, -0.4}, {0.4, 0.4}, Stance::upright, true});
            break;
        }
    return all;
}

/// A road across the land.
inline Ways ways()
{
    Ways ways;
    std::vector<glm::dvec2> road;
    for (int i = 0; i <= 300; ++i)
        road.emplace_back(-1500.0 + 10.0 * i, 200.0 * std::sin(i / 30.0));
    ways.keepClear.push_back({road, 4.0});
    ways.paths.push_back(road);
    return ways;
}

} // namespace scenerytest
