// SPDX-License-Identifier: Apache-2.0
#include "FlightAircraft.h"

#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/jsbsim/JsbsimFile.h"
#include "simulation/vehicle/jsbsim/JsbsimVehicle.h"

namespace trainer
{

namespace
{

/// What JSBSim is to fly; nothing: the aircraft is one of our own.
foundation::Result<std::optional<simulation::JsbsimData>> jsbsimOf(const FlyRequest& request)
{
    std::error_code ignored;
    simulation::JsbsimData data;
    if (simulation::isJsbsimFile(request.aircraft))
    {
        auto read = simulation::readJsbsimAircraft(request.aircraft);
        if (!read) return read.error();
        data = std::move(*read);
    }
    else if (!request.jsbsimRoot.empty() && !std::filesystem::exists(request.aircraft, ignored))
        data.name = data.aircraft = request.aircraft.string();
    else if (!request.jsbsimRoot.empty())
        return foundation::Error{"--jsbsim-root", "the aircraft is a file that JSBSim does not fly",
                                 "write --aircraft NAME, a folder of aircraft/ there"};
    else
        return std::optional<simulation::JsbsimData>();
    if (!request.jsbsimRoot.empty()) data.root = request.jsbsimRoot;
    if (!request.jsbsim.empty()) data.program = request.jsbsim;
    if (data.root.empty())
        return foundation::Error{data.name, "it names no root of JSBSim", "write --jsbsim-root FOLDER"};
    return std::optional(std::move(data));
}

} // namespace

foundation::Result<std::unique_ptr<simulation::DynamicVehicle>>
aircraftOf(const FlyRequest& request, const std::optional<simulation::Geodetic>& origin)
{
    auto jsbsim = jsbsimOf(request);
    if (!jsbsim) return jsbsim.error();
    if (*jsbsim)
        return std::unique_ptr<simulation::DynamicVehicle>(std::make_unique<simulation::JsbsimVehicle>(
            std::make_shared<const simulation::JsbsimData>(std::move(**jsbsim)), simulation::earthOf(origin),
            request.seed));
    auto aircraft = simulation::openVehicle(request.aircraft, origin, request.seed);
    if (!aircraft) return aircraft.error();
    if (!dynamic_cast<const simulation::Aircraft*>(aircraft->get()))
        return foundation::Error{request.aircraft.string(), "is a road vehicle",
                                 "give the data file of an aircraft, or write trainer drive"};
    return aircraft;
}

foundation::Outcome checkAircraft(const FlyRequest& request)
{
    const auto jsbsim = jsbsimOf(request);
    if (!jsbsim) return jsbsim.error();
    if (*jsbsim) return foundation::success();
    const auto aircraft = aircraftOf(request, std::nullopt);
    return aircraft ? foundation::success() : aircraft.error();
}

} // namespace trainer
