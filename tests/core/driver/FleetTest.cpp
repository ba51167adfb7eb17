// SPDX-License-Identifier: Apache-2.0
// 50 cars with their drivers on hilly roads and 10 aircraft with their autopilots in gusts, on one core.
#include <ctime>

#include "DriverSupport.h"
#include "simulation/control/ControlledVehicle.h"
#include "simulation/control/flight/Autopilot.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"

namespace
{

using namespace simulation;
using testsupport::Ride;

/// Hills of 3 m over 200 m, asphalt.
class HillyGround : public Ground
{
public:
    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double x = points[i].x / 32.0, y = points[i].y / 32.0;
            const glm::dvec3 across(-3.0 / 32.0 * std::cos(x) * std::cos(y),
                                    3.0 / 32.0 * std::sin(x) * std::sin(y), 1.0);
            answers[i] = {3.0 * std::sin(x) * std::cos(y), glm::normalize(across), GroundKind::asphalt, true};
        }
    }
};

/// A circle of 120 m about a place.
DriverPath ring(const glm::dvec2& middle)
{
    std::vector<DriverPoint> points;
    for (int i = 0; i < 720; ++i)
        points.push_back(
            {{middle.x + 120.0 * std::sin(i / 120.0), middle.y - 120.0 * std::cos(i / 120.0), 0.0}, 15.0});
    return DriverPath(points);
}

TEST(Fleet, OfFiftyCarsAndTenAircraftIsFasterThanRealTime)
{
    const auto ground = std::make_shared<const HillyGround>();
    std::vector<std::unique_ptr<Ride>> cars;
    for (int i = 0; i < 50; ++i)
        cars.push_back(
            std::make_unique<Ride>("car", ring({400.0 * (i % 10), 400.0 * (i / 10)}), ground, 10.0));
    const auto read = readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
    ASSERT_TRUE(read);
    const auto data = std::make_shared<const AircraftData>(*read);
    const auto earth = std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0});
    WeatherSettings weather;
    weather.windAtSixMetresMps = weather.gustDeviationMps = 1.5;
    const WeatherAir air(weather);
    std::vector<std::unique_ptr<ControlledVehicle>> aircraft;
    for (int i = 0; i < 10; ++i)
    {
        auto one = std::make_unique<Aircraft>(data, earth, static_cast<std::uint64_t>(i + 1));
        ASSERT_TRUE(one->begin({{500.0 * i, 0.0, 400.0 + 20.0 * i}, 0.3 * i, 50.0, true}, *ground, air));
        auto pilot = Autopilot::create(
            {earth, {{FlightOrderKind::heading, 36.0 * i}, {FlightOrderKind::wait, 60.0}}, {}}, *one);
        ASSERT_TRUE(pilot);
        aircraft.push_back(std::make_unique<ControlledVehicle>(
            std::move(one), std::make_unique<Autopilot>(std::move(*pilot))));
        aircraft.back()->look();
    }
    constexpr int kSeconds = 3;
    const std::clock_t started = std::clock();
    std::clock_t ofCars = 0;
    for (int i = 0; i < 120 * kSeconds; ++i)
    {
        const std::clock_t before = std::clock();
        for (const auto& car : cars)
            car->step();
        ofCars += std::clock() - before;
        for (const auto& one : aircraft)
            one->step(*ground, air, {});
    }
    const double wholeS = static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
    const double carsS = static_cast<double>(ofCars) / CLOCKS_PER_SEC;
    std::printf(
        "a simulated second takes %.3f s of processor time: a car %.1f us a step, an aircraft %.1f us\n",
        wholeS / kSeconds, 1e6 * carsS / (50.0 * 120.0 * kSeconds),
        1e6 * (wholeS - carsS) / (10.0 * 120.0 * kSeconds));
    for (const auto& car : cars)
    {
        EXPECT_EQ(car->vehicle().status().condition, VehicleCondition::sound);
        EXPECT_GT(car->speedMps(), 5.0);
    }
    for (const auto& one : aircraft)
        EXPECT_EQ(one->vehicle().status().condition, VehicleCondition::sound);
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT(wholeS, kSeconds); // a tenth of it at -O3
#endif
}

} // namespace
