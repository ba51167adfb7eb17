// SPDX-License-Identifier: Apache-2.0
// Cars by chance among things by chance.
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

#include "../driving/RoadSupport.h"
#include "simulation/contact/ObstacleMap.h"

namespace
{

using namespace simulation;

constexpr int kThings = 400'000;
constexpr double kHalfSideM = 3000.0;
/// Of the point below the rear axle: a tail that is pressed in goes 1 m deep; a car that falls goes on
/// falling.
constexpr double kDeepestM = 2.0;

std::shared_ptr<const ObstacleMap> randomThings()
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(-kHalfSideM, kHalfSideM), turn(0.0, 6.28), share(0.0, 1.0);
    std::uniform_int_distribution<int> kind(0, kStandingKinds - 1);
    ObstacleList list;
    for (int i = 0; i < kThings; ++i)
    {
        Obstacle thing;
        thing.kind = static_cast<ObstacleKind>(kind(random));
        thing.isRound = share(random) < 0.6;
        thing.middle = {place(random), place(random)};
        const double heading = turn(random);
        thing.along = {std::cos(heading), std::sin(heading)};
        thing.halfM = thing.isRound ? glm::dvec2(0.05 + 0.4 * share(random))
                                    : glm::dvec2(0.5 + 3.0 * share(random), 0.1 + share(random));
        thing.lowM = -1.0;
        thing.highM = 0.4 + 5.0 * share(random);
        list.add(thing);
    }
    return std::make_shared<const ObstacleMap>(std::move(list));
}

/// So many drives of a car, by a seed.
struct Drives
{
    int count = 0;
    double seconds = 0.0; ///< of each
    std::uint64_t seed = 5;
};

/// Drives with inputs that change by chance, and returns the processor time of a step. Units: seconds.
double driveByChance(const std::shared_ptr<const ObstacleMap>& map, const Drives& drives,
                     std::size_t& impacts)
{
    std::mt19937_64 random(drives.seed);
    std::uniform_real_distribution<double> place(-0.9 * kHalfSideM, 0.9 * kHalfSideM), share(0.0, 1.0);
    const LevelGround ground;
    const WeatherAir air;
    long steps = 0;
    const std::clock_t begun = std::clock();
    for (int drive = 0; drive < drives.count; ++drive)
    {
        RoadVehicle car(testsupport::roadVehicle("car"));
        car.meet(map);
        const double heading = 2.0 * std::numbers::pi * share(random);
        car.place({{place(random), place(random), 0.0}, heading, 40.0 * share(random)}, ground);
        for (int i = 0; i < static_cast<int>(drives.seconds / RoadVehicle::kStepS); ++i)
        {
            if (i % 60 == 0)
            {
                testsupport::setInput(car, RoadInput::steering, 2.0 * share(random) - 1.0);
                testsupport::setInput(car, RoadInput::throttle, share(random));
                testsupport::setInput(car, RoadInput::brake, share(random) < 0.2 ? 1.0 : 0.0);
                testsupport::setInput(car, RoadInput::gear, share(random) < 0.2 ? -1.0 : 1.0);
            }
            car.step(ground, air);
            ++steps;
            const VehicleState state = car.state();
            EXPECT_GT(state.position.z, -kDeepestM) << "through the ground in drive " << drive;
            EXPECT_LT(state.position.z, 8.0) << "into the sky in drive " << drive;
            if (testing::Test::HasFailure()) return 0.0;
        }
        EXPECT_NE(car.status().condition, VehicleCondition::failed) << drive << ": " << car.status().reason;
        impacts += car.impacts().size();
    }
    return static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC / static_cast<double>(steps);
}

TEST(RandomDrives, StayOnTheGroundAmongFourHundredThousandThings)
{
    const auto map = randomThings();
    std::size_t impacts = 0, none = 0;
    const double amongS = driveByChance(map, {60, 10.0}, impacts);
    const double aloneS = driveByChance(nullptr, {60, 10.0}, none);
    std::printf("%zu impacts; a step takes %.1f us, without things %.1f us\n", impacts, 1e6 * amongS,
                1e6 * aloneS);
    EXPECT_GT(impacts, 50U);
    EXPECT_EQ(none, 0U);
}

/// One of four parts, which run beside each other.
void driveAQuarter(std::uint64_t seed)
{
    std::size_t impacts = 0;
    driveByChance(randomThings(), {250, 60.0, seed}, impacts);
    EXPECT_GT(impacts, 250U);
}

TEST(ThousandRandomDrives, FirstStayOnTheGround)
{
    driveAQuarter(5);
}

TEST(ThousandRandomDrives, SecondStayOnTheGround)
{
    driveAQuarter(6);
}

TEST(ThousandRandomDrives, ThirdStayOnTheGround)
{
    driveAQuarter(7);
}

TEST(ThousandRandomDrives, LastStayOnTheGround)
{
    driveAQuarter(8);
}

} // namespace
