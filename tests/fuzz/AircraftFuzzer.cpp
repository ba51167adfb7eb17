// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as an aircraft: they are read and flown for a moment, or refused.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace simulation;

constexpr int kSteps = 60;

void require(bool condition)
{
    if (!condition) std::abort();
}

bool isFinite(const VehicleState& state)
{
    return std::isfinite(state.position.x + state.position.y + state.position.z + state.velocity.x +
                         state.velocity.y + state.velocity.z + state.bodyRates.x + state.bodyRates.y +
                         state.bodyRates.z + state.bodyToScene.w + state.bodyToScene.x + state.bodyToScene.y +
                         state.bodyToScene.z);
}

/// From a height above the ground, with everything moved.
void fly(const std::shared_ptr<const AircraftData>& data, const std::shared_ptr<const EarthFrame>& earth,
         double heightM)
{
    Aircraft aircraft(data, earth);
    FlightState state = aircraft.flightState();
    state.motion.position.z = heightM;
    state.motion.velocity = {30.0, 20.0, -2.0};
    state.engineRadps = 200.0;
    aircraft.place(state);
    for (double& input : aircraft.inputs())
        input = 0.7;
    for (int i = 0; i < kSteps; ++i)
    {
        aircraft.step(LevelGround(), WeatherAir());
        require(isFinite(aircraft.state()));
    }
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto read = parseAircraft({reinterpret_cast<const char*>(data), size}, "fuzz");
    if (!read) return 0;
    static const auto earth = std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0});
    const auto aircraft = std::make_shared<const AircraftData>(*read);
    fly(aircraft, earth, 500.0);
    fly(aircraft, earth, 1.0);
    return 0;
}
