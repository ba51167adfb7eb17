// SPDX-License-Identifier: Apache-2.0
// A step of an aircraft: in still air, in turbulence, and on its wheels. `flight_bench AIRCRAFT.xml`.
#include <algorithm>
#include <cstdio>
#include <memory>

#include <benchmark/benchmark.h>

#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"
#include "simulation/vehicle/flight/Trim.h"

namespace
{

using namespace simulation;

/// An aircraft in level flight at 1000 m, or on its wheels.
Aircraft aircraftOf(const std::shared_ptr<const AircraftData>& data, bool stands)
{
    const auto earth = std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0});
    Aircraft aircraft(data, earth);
    FlightState state = aircraft.flightState();
    state.motion.position.z = 1.3;
    state.motion.attitude = levelAttitude(earth->placeAt(state.motion.position), 0.0, 0.0, 0.0);
    if (!stands)
    {
        TrimTarget target;
        target.position.z = 1000.0;
        const auto flight = trim(*data, *earth, WeatherAir().at(target.position, 1000.0, 0.0), target);
        if (flight)
            state = flight->state,
            std::copy(flight->inputs.begin(), flight->inputs.end(), aircraft.inputs().begin());
    }
    aircraft.place(state);
    return aircraft;
}

void flies(benchmark::State& state, const std::shared_ptr<const AircraftData>& data, bool stands,
           double gustsMps)
{
    WeatherSettings weather;
    weather.gustDeviationMps = weather.windAtSixMetresMps = gustsMps;
    const WeatherAir air(weather);
    const LevelGround ground;
    Aircraft aircraft = aircraftOf(data, stands);
    const FlightState start = aircraft.flightState();
    int steps = 0;
    for ([[maybe_unused]] auto _ : state)
    {
        if (++steps % 1200 == 0) aircraft.place(start);
        aircraft.step(ground, air);
    }
    benchmark::DoNotOptimize(aircraft.state());
}

} // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    const auto read = simulation::readAircraft(argc > 1 ? argv[1] : "data/aircraft/c172p.xml");
    if (!read) return std::fprintf(stderr, "flight_bench: %s\n", read.error().message().c_str()), 1;
    const auto data = std::make_shared<const AircraftData>(*read);
    benchmark::RegisterBenchmark("still air",
                                 [&](benchmark::State& state) { flies(state, data, false, 0.0); });
    benchmark::RegisterBenchmark("turbulence",
                                 [&](benchmark::State& state) { flies(state, data, false, 2.0); });
    benchmark::RegisterBenchmark("on the ground",
                                 [&](benchmark::State& state) { flies(state, data, true, 0.0); });
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
