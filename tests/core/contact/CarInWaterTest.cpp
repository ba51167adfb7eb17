// SPDX-License-Identifier: Apache-2.0
// A car that drives into the sea.
#include <cmath>

#include "../driving/RoadSupport.h"

namespace
{

using namespace simulation;

/// A quay: asphalt up to x = 20 m, then water, its bed 6 m below.
class Quay final : public Ground
{
public:
    explicit Quay(double depthM) : _depthM(depthM) {}

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            answers[i] = {0.0, {0.0, 0.0, 1.0}, GroundKind::asphalt, true};
            if (points[i].x > 20.0)
                answers[i] = {-0.3, {0.0, 0.0, 1.0}, GroundKind::water, true, 1.0, _depthM};
        }
    }

private:
    double _depthM;
};

TEST(CarInWater, StopsFloatsAndSinks)
{
    const Quay quay(6.0);
    RoadVehicle car(testsupport::roadVehicle("car"));
    car.place({{0.0, 0.0, 0.0}, 0.0, 38.0}, quay);
    testsupport::stepFor(car, quay, 6.0);
    EXPECT_EQ(car.status().condition, VehicleCondition::crashed);
    EXPECT_EQ(car.status().reason, "it drove into water");
    EXPECT_LT(glm::length(car.state().velocity), 3.0) << "it drove over the sea at 38 m/s";
    EXPECT_LT(car.state().position.x, 90.0);
    EXPECT_GT(car.state().position.z, -1.5) << "it floats";
    double sunkS = 6.0;
    while (car.state().position.z > -2.5 && sunkS < 200.0)
    {
        testsupport::stepFor(car, quay, 1.0);
        sunkS += 1.0;
    }
    std::printf("sunk after %.0f s\n", sunkS);
    EXPECT_GT(sunkS, 15.0);
    EXPECT_LT(sunkS, 120.0);
    testsupport::stepFor(car, quay, 60.0);
    EXPECT_LT(car.state().position.z, -4.5) << "on the bed";
    EXPECT_GT(car.state().position.z, -6.6);
    EXPECT_LT(glm::length(car.state().velocity), 0.1);
}

TEST(CarInWater, AFordIsDrivenThrough)
{
    const Quay ford(0.15); // its bed 0.45 m below the quay, 0.15 m of water over it
    RoadVehicle car(testsupport::roadVehicle("car"));
    car.place({{25.0, 0.0, 0.0}, 0.0, 5.0}, ford);
    car.roadInputs()[static_cast<std::size_t>(RoadInput::gear)] = 1.0;
    car.roadInputs()[static_cast<std::size_t>(RoadInput::throttle)] = 0.4;
    testsupport::stepFor(car, ford, 5.0);
    EXPECT_EQ(car.status().condition, VehicleCondition::sound) << car.status().reason;
    EXPECT_GT(car.state().position.x, 40.0);
}

} // namespace
