// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/scenario/VehicleFiles.h"

#include <foundation/Angle.h>
#include <foundation/DataFile.h>
#include <foundation/XmlSource.h>

#include "simulation/control/RecordedInputs.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"
#include "simulation/vehicle/jsbsim/JsbsimFile.h"
#include "simulation/vehicle/jsbsim/JsbsimVehicle.h"
#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace simulation
{
namespace
{

using Opened = foundation::Result<std::unique_ptr<DynamicVehicle>>;

Opened openRoadVehicle(const std::filesystem::path& file, const std::optional<Geodetic>& origin)
{
    auto data = readRoadVehicle(file);
    if (!data) return data.error();
    return std::unique_ptr<DynamicVehicle>(std::make_unique<RoadVehicle>(
        std::make_shared<const RoadVehicleData>(std::move(*data)), origin ? earthOf(origin) : nullptr));
}

Opened openAircraft(const std::filesystem::path& file, const std::optional<Geodetic>& origin,
                    std::uint64_t seed)
{
    auto data = readAircraft(file);
    if (!data) return data.error();
    return std::unique_ptr<DynamicVehicle>(std::make_unique<Aircraft>(
        std::make_shared<const AircraftData>(std::move(*data)), earthOf(origin), seed));
}

Opened openJsbsim(const std::filesystem::path& file, const std::optional<Geodetic>& origin,
                  std::uint64_t seed)
{
    auto data = readJsbsimAircraft(file);
    if (!data) return data.error();
    if (data->root.empty())
        return foundation::Error{file.string(), "names no root of JSBSim",
                                 "write root=\"FOLDER\", where its aircraft/ lies"};
    return std::unique_ptr<DynamicVehicle>(std::make_unique<JsbsimVehicle>(
        std::make_shared<const JsbsimData>(std::move(*data)), earthOf(origin), seed));
}

} // namespace

std::filesystem::path vehicleFileFor(const ScenarioObject& object)
{
    if (object.isAirborne()) return foundation::dataFile("aircraft/c172p.xml");
    const auto* const vehicle = std::get_if<Vehicle>(&object.object);
    const std::string category = vehicle ? vehicle->category : "";
    if (category == "bus" || category == "truck" || category == "semitrailer")
        return foundation::dataFile("vehicles/bus.xml");
    return foundation::dataFile(category == "van" ? "vehicles/van.xml" : "vehicles/car.xml");
}

std::shared_ptr<const EarthFrame> earthOf(const std::optional<Geodetic>& origin)
{
    return std::make_shared<const EarthFrame>(origin.value_or(Geodetic{46.0, 8.0, 0.0}));
}

Opened openVehicle(const std::filesystem::path& file, const std::optional<Geodetic>& origin,
                   std::uint64_t seed)
{
    constexpr std::size_t kMostFileBytes = 4U << 20U;
    const auto source = foundation::XmlSource::read(file, kMostFileBytes);
    if (!source) return source.error();
    const std::string_view root = (*source)->root().name();
    if (root == "roadVehicle") return openRoadVehicle(file, origin);
    if (root == "aircraft") return openAircraft(file, origin, seed);
    if (root == "jsbsim_aircraft") return openJsbsim(file, origin, seed);
    return foundation::Error{file.string(), "is no data file of a vehicle",
                             "give one whose root is roadVehicle, aircraft or jsbsim_aircraft"};
}

foundation::Result<std::unique_ptr<VehicleController>> openInputs(const std::filesystem::path& file,
                                                                  const DynamicVehicle& vehicle)
{
    auto track = readInputs(file);
    if (!track) return track.error();
    auto inputs = RecordedInputs::create(std::move(*track), vehicle, file.string());
    if (!inputs) return inputs.error();
    return std::unique_ptr<VehicleController>(std::make_unique<RecordedInputs>(std::move(*inputs)));
}

RunwayStrip runwayOn(const Ground& ground, const glm::dvec2& threshold, double courseDeg, double lengthM,
                     double widthM)
{
    constexpr double kFromM = 1e4;
    const glm::dvec3 place(threshold, kFromM);
    GroundPoint below;
    ground.below({&place, 1}, {&below, 1});
    return {{threshold, below.heightM}, foundation::radiansOf(courseDeg), lengthM, widthM};
}

} // namespace simulation
