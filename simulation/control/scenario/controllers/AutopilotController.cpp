// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/Autopilot.h"
#include "simulation/control/scenario/VehicleControllers.h"
#include "simulation/control/scenario/VehicleFiles.h"

namespace simulation
{
namespace
{

constexpr std::string_view kAutopilotProperties[] = {"orders", "strip"};

foundation::Result<std::unique_ptr<VehicleController>> makeAutopilot(ControllerProperties& properties,
                                                                     const ControllerSite& site)
{
    AutopilotSettings settings{site.earth, {}, {}};
    const std::string orders = properties.text("orders");
    const std::vector<double> strip = properties.numbers("strip", 4, 5);
    if (properties.error()) return *properties.error();
    if (!strip.empty())
        settings.runway = runwayOn(site.ground, {strip[0], strip[1]}, strip[2], strip[3],
                                   strip.size() > 4 ? strip[4] : RunwayStrip().widthM);
    if (!orders.empty())
    {
        auto read = parseFlightOrders(orders, "property orders");
        if (!read) return read.error();
        settings.orders = std::move(*read);
    }
    auto pilot = Autopilot::create(std::move(settings), site.vehicle);
    if (!pilot)
        return foundation::Error{"property orders", pilot.error().what,
                                 "give the property strip, other orders, or the data file of an aircraft"};
    return std::unique_ptr<VehicleController>(std::make_unique<Autopilot>(std::move(*pilot)));
}

} // namespace

VehicleControllerMaker autopilotController()
{
    return {"Autopilot", kAutopilotProperties, makeAutopilot};
}

} // namespace simulation
