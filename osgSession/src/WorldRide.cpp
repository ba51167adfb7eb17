// SPDX-License-Identifier: Apache-2.0
#include "WorldRide.h"

#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>

#include "core/RideScenario.h"
#include "scene/DriveWay.h"
#include "scene/RideAir.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace osgSession
{

namespace
{

constexpr double kAheadM = 1000.0; ///< of the start: the way goes on so far at least where roads do

/// A place behind the threshold of a strip, and in the air where a world has none. Units: metres, m/s.
constexpr double kBehindThresholdM = 20.0, kInAirM = 300.0, kInAirMps = 50.0;

foundation::Result<simulation::Scenario> driveInWorld(const trainer::SceneTerrain& scene,
                                                      const std::filesystem::path& world,
                                                      const simulation::RoadVehicleData& data, double startM)
{
    const auto way = trainer::driveWay(scene, world.string(), startM + kAheadM);
    if (!way) return way.error();
    if (startM < 0.0 || startM > way->lengthM())
    {
        char text[80];
        std::snprintf(text, sizeof text, "the way of the drive is %.0f m long, the start is at %.0f m",
                      way->lengthM(), startM);
        return foundation::Error{world.string(), text, "give a start on the way"};
    }
    return core::driveScenario(data, {way->placeAt(startM), way->headingRadAt(startM)}, scene.origin(),
                               trainer::inAirOf(scene, {}));
}

foundation::Result<simulation::Scenario> flightInWorld(const trainer::SceneTerrain& scene,
                                                       const simulation::Ground& ground,
                                                       const std::filesystem::path& world)
{
    core::RideBegin begin;
    double aboveM = kInAirM;
    if (const auto strip = trainer::runwayInUse(scene.runways, std::nullopt))
    {
        begin.headingRad = foundation::radiansOf(90.0 - strip->courseDeg);
        const glm::dvec2 ahead(std::cos(begin.headingRad), std::sin(begin.headingRad));
        begin.place = glm::dvec3(strip->threshold + kBehindThresholdM * ahead, 0.0);
        aboveM = 0.0;
    }
    else
    {
        begin.headingRad = foundation::radiansOf(90.0);
        begin.speedMps = kInAirMps;
    }
    constexpr double kFromM = 1e4;
    const glm::dvec3 above(glm::dvec2(begin.place), kFromM);
    simulation::GroundPoint below;
    ground.below({&above, 1}, {&below, 1});
    if (!below.isKnown)
        return foundation::Error{world.string(), "there is no ground at the start of the flight",
                                 "give a world with a runway or with ground in its middle"};
    begin.place.z = below.heightM + aboveM;
    return core::flightScenario(begin, scene.origin(), trainer::inAirOf(scene, {}));
}

} // namespace

foundation::Result<simulation::Scenario> rideInWorld(const trainer::SceneTerrain& scene,
                                                     const simulation::Ground& ground,
                                                     const std::filesystem::path& world,
                                                     const simulation::DynamicVehicle& vehicle, double startM)
{
    if (const auto* const car = dynamic_cast<const simulation::RoadVehicle*>(&vehicle))
        return driveInWorld(scene, world, car->data(), startM);
    return flightInWorld(scene, ground, world);
}

} // namespace osgSession
