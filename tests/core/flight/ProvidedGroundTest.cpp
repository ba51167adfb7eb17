// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/ProvidedGround.h"

#include "FlightSupport.h"

namespace
{

using namespace simulation;

/// A plane that rises by a tenth to the east, within 100 m; above it, east of 50 m, a bridge at 20 m.
std::optional<GroundSample> planeAndBridge(double eastM, double northM, double fromM)
{
    if (std::abs(eastM) > 100.0 || std::abs(northM) > 100.0) return std::nullopt;
    if (eastM > 50.0 && fromM > 20.0) return GroundSample{20.0};
    return GroundSample{0.1 * eastM};
}

GroundPoint below(const Ground& ground, const glm::dvec3& point)
{
    GroundPoint answer;
    ground.below({&point, 1}, {&answer, 1});
    return answer;
}

TEST(ProvidedGroundTest, HasHeightAndNormalOfItsProvider)
{
    const ProvidedGround ground{GroundProvider(planeAndBridge), GroundKind::gravel};
    const GroundPoint point = below(ground, {10.0, 5.0, 3.0});
    EXPECT_TRUE(point.isKnown);
    EXPECT_DOUBLE_EQ(point.heightM, 1.0);
    EXPECT_NEAR(point.normal.x, -0.1 / std::sqrt(1.01), 1e-12);
    EXPECT_NEAR(point.normal.z, 1.0 / std::sqrt(1.01), 1e-12);
    EXPECT_EQ(point.kind, GroundKind::gravel);
}

TEST(ProvidedGroundTest, TellsTheBridgeFromTheGroundBelowIt)
{
    const ProvidedGround ground{GroundProvider(planeAndBridge)};
    EXPECT_DOUBLE_EQ(below(ground, {60.0, 0.0, 21.0}).heightM, 20.0);
    EXPECT_DOUBLE_EQ(below(ground, {60.0, 0.0, 19.9}).heightM, 20.0)
        << "a wheel pressed in still stands on it";
    EXPECT_DOUBLE_EQ(below(ground, {60.0, 0.0, 8.0}).heightM, 6.0);
}

TEST(ProvidedGroundTest, OutsideTheDataNothingIsKnown)
{
    EXPECT_FALSE(below(ProvidedGround{GroundProvider(planeAndBridge)}, {99.8, 0.0, 0.0}).isKnown);
    EXPECT_FALSE(below(ProvidedGround{GroundProvider()}, {0.0, 0.0, 0.0}).isKnown);
}

// A world without ground: the aircraft flies on below the height 0, and nothing breaks.
TEST(ProvidedGroundTest, AnAircraftFliesWithoutGround)
{
    Aircraft aircraft = testsupport::standing(10.0);
    for (int i = 0; i < 600; ++i)
        aircraft.step(ProvidedGround{GroundProvider()}, WeatherAir());
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::sound);
    EXPECT_LT(aircraft.state().position.z, 0.0);
}

} // namespace
