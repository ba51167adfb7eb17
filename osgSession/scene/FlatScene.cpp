// SPDX-License-Identifier: Apache-2.0
#include "FlatScene.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include <osgTerrainROAM/core/RoamFile.h>

namespace trainer
{

namespace
{

namespace core = osgTerrainROAM::core;

constexpr double kMostDeg = 5.0, kMostLatitudeDeg = 80.0;
constexpr double kAroundDeg = 0.18; ///< of latitude: 20 km
constexpr double kMetresPerDeg = 111e3;
constexpr int kCells = 256, kNodeStep = 16;

struct Extent
{
    double south = 90.0, north = -90.0, west = 180.0, east = -180.0;
    std::vector<double> heights{};

    void include(const simulation::TrackFix& fix)
    {
        south = std::min(south, fix.latitudeDeg);
        north = std::max(north, fix.latitudeDeg);
        west = std::min(west, fix.longitudeDeg);
        east = std::max(east, fix.longitudeDeg);
        if (fix.heightM) heights.push_back(*fix.heightM);
    }

    /// The height that one fix of fifty is below; 0 without heights.
    double lowM()
    {
        if (heights.empty()) return 0.0;
        const auto at = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 50);
        std::nth_element(heights.begin(), at, heights.end());
        return *at;
    }
};

core::HeightField flatField(Extent extent)
{
    const double aroundEast =
        kAroundDeg / std::cos(foundation::radiansOf(0.5 * (extent.south + extent.north)));
    core::HeightField field;
    field.name = "flat ground";
    field.columns = field.rows = kCells + 1;
    field.heightsM.assign(static_cast<std::size_t>(field.columns) * field.rows,
                          static_cast<float>(extent.lowM()));
    const double south = extent.south - kAroundDeg, west = extent.west - aroundEast;
    const double high = extent.north + kAroundDeg - south, wide = extent.east + aroundEast - west;
    field.spacingNorthM = high * kMetresPerDeg / kCells;
    field.spacingEastM = wide * kMetresPerDeg * kAroundDeg / aroundEast / kCells;
    core::GeodeticNet net;
    net.step = kNodeStep;
    net.nodesPerSide = kCells / kNodeStep + 1;
    for (int row = 0; row < net.nodesPerSide; ++row)
        for (int column = 0; column < net.nodesPerSide; ++column)
            net.nodes.push_back(
                {south + high * row * kNodeStep / kCells, west + wide * column * kNodeStep / kCells, 0.0});
    field.net = std::move(net);
    return field;
}

} // namespace

foundation::Result<SceneTerrain> makeFlatScene(const std::vector<simulation::FlightTrack>& tracks,
                                               std::vector<osgTerrainROAM::core::GroundFeature> painted)
{
    Extent extent;
    for (const simulation::FlightTrack& track : tracks)
        if (track.kind != simulation::TrackKind::mark)
            for (const simulation::TrackFix& fix : track.fixes)
                extent.include(fix);
    const double farthest = std::max(std::fabs(extent.south), std::fabs(extent.north));
    if (!(extent.north - extent.south <= kMostDeg && extent.east - extent.west <= kMostDeg &&
          farthest <= kMostLatitudeDeg))
        return foundation::Error{"--terrain",
                                 "the recording reaches too far for flat ground to be made below it",
                                 "give a terrain of that place"};
    core::RoamFile description;
    description.land.water = osgTerrainROAM::core::WaterRule::none;
    const auto tile = std::make_shared<core::RoamTile>(core::PlacedTile(flatField(std::move(extent))));
    auto terrain = osgTerrainROAM::makeTerrain(description, tile, {std::move(painted), {}});
    if (!terrain) return terrain.error();
    return SceneTerrain{terrain->get(), *terrain, nullptr};
}

foundation::Result<SceneTerrain> makeLevelScene(const simulation::Geodetic& middle,
                                                std::vector<osgTerrainROAM::core::GroundFeature> painted)
{
    simulation::FlightTrack there;
    simulation::TrackFix& fix = there.fixes.emplace_back();
    fix.latitudeDeg = middle.latitudeDeg;
    fix.longitudeDeg = middle.longitudeDeg;
    fix.heightM = middle.heightM;
    return makeFlatScene({there}, std::move(painted));
}

} // namespace trainer
