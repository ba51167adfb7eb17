// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/scenario/ScenarioMotions.h"

#include <vector>

#include <foundation/Fnv1a.h>

#include "simulation/control/VehicleMotion.h"
#include "simulation/control/scenario/VehicleControllers.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/vehicle/WeatherAir.h"

namespace simulation
{
namespace
{

using foundation::Result;

/// What the properties say of the vehicle, whoever drives it.
struct VehicleWish
{
    std::filesystem::path file;
    std::uint64_t seed = 0;
    double turbulenceMps = 0.0; ///< deviation above 600 m
};

VehicleWish vehicleWish(ControllerProperties& properties, const ScenarioObject& object)
{
    constexpr double kMostSeed = 4294967295.0;
    VehicleWish wish;
    wish.file = properties.file("vehicle", vehicleFileFor(object));
    wish.seed = static_cast<std::uint64_t>(properties.number("seed", 0.0, 0.0, kMostSeed));
    wish.turbulenceMps = properties.number("turbulence", 0.0, 0.0, 20.0);
    return wish;
}

ControllerProperties propertiesOf(const Controller& controller, const std::filesystem::path& folder)
{
    const auto own = vehicleControllerOf(controller).properties;
    std::vector<std::string_view> names(std::begin(kVehicleProperties), std::end(kVehicleProperties));
    names.insert(names.end(), own.begin(), own.end());
    return {controller, folder, names};
}

/// The series of random numbers of one entity.
std::uint64_t seedOf(std::uint64_t seed, const std::string& entity)
{
    foundation::Fnv1a hash(seed ^ foundation::Fnv1a().value()); // begins with the seed itself
    hash.add(entity);
    return hash.value();
}

} // namespace

ScenarioMotions::ScenarioMotions(World world) : _world(std::move(world)), _earth(earthOf(_world.origin)) {}

foundation::Outcome ScenarioMotions::check(const Controller& controller, const ScenarioObject& object)
{
    ControllerProperties properties = propertiesOf(controller, _world.folder);
    const VehicleWish wish = vehicleWish(properties, object);
    if (properties.error()) return *properties.error();
    const auto vehicle = openVehicle(wish.file, _world.origin, wish.seed);
    if (!vehicle) return vehicle.error();
    const auto controls =
        vehicleControllerOf(controller).make(properties, {**vehicle, _earth, *_world.ground, nullptr});
    if (!controls) return controls.error();
    return foundation::success();
}

Result<std::shared_ptr<ExternalMotion>>
ScenarioMotions::make(const Controller& controller, const ScenarioObject& object, const MotionStart& start)
{
    ControllerProperties properties = propertiesOf(controller, _world.folder);
    const VehicleWish wish = vehicleWish(properties, object);
    if (properties.error()) return *properties.error();
    auto vehicle = openVehicle(wish.file, _world.origin, seedOf(_world.seed + wish.seed, object.name));
    if (!vehicle) return vehicle.error();
    auto controls =
        vehicleControllerOf(controller).make(properties, {**vehicle, _earth, *_world.ground, &start});
    if (!controls) return controls.error();
    auto motion = std::make_shared<VehicleMotion>(
        std::make_unique<ControlledVehicle>(std::move(*vehicle), std::move(*controls)), _world.ground,
        std::make_shared<const WeatherAir>());
    motion->followWeather(_world.origin ? _world.origin->heightM : 0.0, wish.turbulenceMps);
    if (auto begun = motion->begin(start.state, start.isAirborne, start.timeS, start.environment); !begun)
        return begun.error();
    return std::shared_ptr<ExternalMotion>(std::move(motion));
}

} // namespace simulation
