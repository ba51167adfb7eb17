// SPDX-License-Identifier: Apache-2.0
// Drives on road networks: the default course and a junction of real data.
#include <cmath>

#include <osgRoads/core/query/ChooseDrive.h>
#include <osgRoads/core/read/ReadNetwork.h>

#include "DriverSupport.h"
#include "RealData.h"
#include "scenery/roads/HeightOnRoads.h"
#include "scenery/roads/LanePath.h"
#include "simulation/vehicle/ProvidedGround.h"

namespace
{

using namespace simulation;
using osgRoads::core::PlacedNetwork;

constexpr double kNoGroundM = -1e4;

std::shared_ptr<const PlacedNetwork> roadsOf(const std::filesystem::path& file)
{
    auto read = osgRoads::core::readNetwork(file);
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    if (!read) return nullptr;
    return std::make_shared<const PlacedNetwork>(
        std::make_shared<const osgRoads::core::RoadNetwork>(std::move(read->network)));
}

/// The roads alone, without land beside them.
std::shared_ptr<const Ground> groundOf(const std::shared_ptr<const PlacedNetwork>& roads)
{
    return std::make_shared<const ProvidedGround>(
        [roads](double east, double north, double from) -> std::optional<GroundSample>
        {
            const double height = scenery::heightOnRoads(*roads, {east, north, kNoGroundM}, from);
            if (height <= kNoGroundM) return std::nullopt;
            return GroundSample{height};
        },
        GroundKind::asphalt);
}

DriverPath wayThrough(const PlacedNetwork& roads, double lengthM)
{
    const auto route = osgRoads::core::chooseDrive(
        roads.network(), osgRoads::core::LaneGraph(roads.network()), lengthM + 100.0);
    std::vector<DriverPoint> points;
    for (const scenery::LanePathPoint& point : scenery::lanePath(roads, route))
        points.push_back({point.place, point.limitMps});
    return DriverPath(points);
}

struct Drive
{
    double worstM = 0.0, drivenM = 0.0;
    VehicleCondition condition = VehicleCondition::sound;
    double fastestMps = 0.0;
};

Drive driveOn(const std::filesystem::path& file, double lengthM)
{
    const auto roads = roadsOf(file);
    if (!roads) return {};
    testsupport::Ride ride("car", wayThrough(*roads, lengthM), groundOf(roads));
    Drive drive;
    while (drive.drivenM < lengthM && ride.timeS() < 0.5 * lengthM && !ride.driver().isDone())
    {
        ride.step();
        drive.drivenM = ride.driver().beside().alongM;
        drive.worstM = std::max(drive.worstM, std::abs(ride.driver().beside().offsetM));
        drive.fastestMps = std::max(drive.fastestMps, ride.speedMps());
    }
    drive.condition = ride.vehicle().status().condition;
    return drive;
}

TEST(DriverRoadTest, KeepsToItsLaneForFiveKilometresOfTheDefaultCourse)
{
    const Drive drive = driveOn(OSGTRAINER_DEFAULT_COURSE, 5000.0);
    EXPECT_EQ(drive.condition, VehicleCondition::sound);
    EXPECT_GE(drive.drivenM, 5000.0);
    EXPECT_LT(drive.worstM, 0.5);
    EXPECT_GT(drive.fastestMps, 15.0);
    RecordProperty("worstMm", static_cast<int>(1000.0 * drive.worstM));
    std::printf("course: %.3f m off at most, up to %.1f m/s\n", drive.worstM, drive.fastestMps);
}

TEST(DriverRoadTest, DrivesThroughTheJunctionOfFabriksgatan)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "openscenario/esmini/xodr");
    const Drive drive = driveOn(folder / "fabriksgatan.xodr", 400.0);
    EXPECT_EQ(drive.condition, VehicleCondition::sound);
    EXPECT_GT(drive.drivenM, 250.0);
    EXPECT_LT(drive.worstM, 0.5);
    std::printf("fabriksgatan: %.3f m off at most on %.0f m\n", drive.worstM, drive.drivenM);
}

} // namespace
