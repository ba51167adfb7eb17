// SPDX-License-Identifier: Apache-2.0
// A step of a road vehicle: on level asphalt, on gravel with all its wheels' noise, and fifty cars in one
// world. `drive_bench [VEHICLE.xml]`.
#include <cstdio>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace
{

using namespace simulation;

using Data = std::shared_ptr<const RoadVehicleData>;

void setOff(RoadVehicle& vehicle)
{
    vehicle.inputs()[static_cast<std::size_t>(RoadInput::throttle)] = 0.2;
    vehicle.inputs()[static_cast<std::size_t>(RoadInput::steering)] = 0.05;
    vehicle.inputs()[static_cast<std::size_t>(RoadInput::gear)] = 3.0;
}

void drives(benchmark::State& state, const Data& data, GroundKind kind)
{
    const LevelGround ground(0.0, kind);
    const WeatherAir air;
    RoadVehicle vehicle(data, std::make_shared<const EarthFrame>(Geodetic{46.0, 8.0, 0.0}));
    vehicle.place({{0.0, 0.0, 0.0}, 0.0, 15.0}, ground);
    setOff(vehicle);
    for ([[maybe_unused]] auto _ : state)
        vehicle.step(ground, air);
    benchmark::DoNotOptimize(vehicle.state());
}

/// One step of fifty vehicles that stand in one world, 10 m apart.
void driveTogether(benchmark::State& state, const Data& data)
{
    const LevelGround ground(0.0, GroundKind::asphalt);
    const WeatherAir air;
    const auto world = std::make_shared<BodyWorld>();
    std::vector<std::unique_ptr<RoadVehicle>> vehicles;
    std::vector<RoadVehicle*> all;
    for (int i = 0; i < 50; ++i)
    {
        vehicles.push_back(std::make_unique<RoadVehicle>(data, nullptr, world));
        vehicles.back()->place({{0.0, 10.0 * i, 0.0}, 0.0, 15.0}, ground);
        all.push_back(vehicles.back().get());
    }
    for ([[maybe_unused]] auto _ : state)
        RoadVehicle::stepTogether(all, ground, air);
    benchmark::DoNotOptimize(all.front()->state());
}

} // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    const auto read = simulation::readRoadVehicle(argc > 1 ? argv[1] : "data/vehicles/car.xml");
    if (!read) return std::fprintf(stderr, "drive_bench: %s\n", read.error().message().c_str()), 1;
    const auto data = std::make_shared<const simulation::RoadVehicleData>(*read);
    benchmark::RegisterBenchmark("asphalt", [&](benchmark::State& state)
                                 { drives(state, data, simulation::GroundKind::asphalt); });
    benchmark::RegisterBenchmark("gravel", [&](benchmark::State& state)
                                 { drives(state, data, simulation::GroundKind::gravel); });
    benchmark::RegisterBenchmark("fifty together",
                                 [&](benchmark::State& state) { driveTogether(state, data); });
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
