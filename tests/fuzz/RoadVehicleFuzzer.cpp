// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a road vehicle: they are read and driven for a moment, or refused.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace simulation;

/// Ground with a kerb and a wall.
class KerbGround : public Ground
{
    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = {points[i].x < 8.0    ? 0.0
                          : points[i].x < 20.0 ? 0.12
                                               : 2.0,
                          {0.0, 0.0, 1.0},
                          GroundKind::gravel,
                          true};
    }
};

bool isFiniteState(const VehicleState& state)
{
    return std::isfinite(state.position.x + state.position.y + state.position.z + state.velocity.x +
                         state.velocity.y + state.velocity.z + state.bodyRates.x + state.bodyRates.y +
                         state.bodyRates.z + state.bodyToScene.w + state.bodyToScene.x + state.bodyToScene.y +
                         state.bodyToScene.z);
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto read = parseRoadVehicle({reinterpret_cast<const char*>(data), size}, "fuzz");
    if (!read) return 0;
    RoadVehicle vehicle(std::make_shared<const RoadVehicleData>(*read));
    const KerbGround ground;
    vehicle.place({{0.0, 0.0, 0.0}, 0.1, 20.0}, ground);
    for (double& input : vehicle.inputs())
        input = 0.7;
    for (int i = 0; i < 90; ++i)
    {
        if (i == 50) vehicle.inputs()[2] = 0.0;
        vehicle.step(ground, WeatherAir());
        if (!isFiniteState(vehicle.state()) || !std::isfinite(vehicle.readings().engineRpm)) std::abort();
    }
    return 0;
}
