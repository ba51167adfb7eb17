// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/DefaultVehicle.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace simulation
{
namespace
{

/// Units: metres, m/s, m/s².
struct DefaultFigures
{
    std::string_view category;
    double length, width, height;
    double wheelbase, rearOverhang, wheelDiameter;
    Performance performance;
};

constexpr std::array kDefault{DefaultFigures{"car", 4.5, 1.8, 1.46, 2.7, 0.95, 0.64, {55.0, 4.0, 9.0}},
                              DefaultFigures{"van", 5.6, 2.02, 2.5, 3.4, 1.18, 0.7, {45.0, 3.0, 8.0}},
                              DefaultFigures{"truck", 9.0, 2.5, 3.7, 5.2, 2.2, 1.0, {25.0, 1.5, 6.0}},
                              DefaultFigures{"semitractor", 6.0, 2.5, 3.6, 3.7, 0.9, 1.0, {25.0, 1.5, 6.0}},
                              DefaultFigures{"bus", 11.9, 2.5, 3.05, 5.9, 3.3, 0.96, {28.0, 1.2, 5.0}},
                              DefaultFigures{"motorbike", 2.1, 0.8, 1.6, 1.42, 0.35, 0.6, {60.0, 5.0, 9.0}},
                              DefaultFigures{"bicycle", 1.8, 0.6, 1.75, 1.06, 0.35, 0.68, {8.0, 1.0, 4.0}},
                              DefaultFigures{"train", 20.0, 2.9, 3.8, 14.0, 3.0, 0.9, {40.0, 1.0, 1.2}},
                              DefaultFigures{"tram", 20.0, 2.4, 3.4, 14.0, 3.0, 0.7, {20.0, 1.2, 2.5}}};

} // namespace

Vehicle defaultVehicle(const std::string& category)
{
    const auto found = std::find_if(kDefault.begin(), kDefault.end(),
                                    [&](const DefaultFigures& usual) { return usual.category == category; });
    const DefaultFigures& usual = found == kDefault.end() ? kDefault.front() : *found;
    const double track = 0.86 * usual.width, radius = 0.5 * usual.wheelDiameter;
    Vehicle vehicle;
    vehicle.name = category;
    vehicle.category = category;
    vehicle.box = {{0.5 * usual.length - usual.rearOverhang, 0.0, 0.5 * usual.height},
                   usual.length,
                   usual.width,
                   usual.height};
    vehicle.performance = usual.performance;
    vehicle.frontAxle = Axle{0.5, usual.wheelDiameter, track, usual.wheelbase, radius};
    vehicle.rearAxle = Axle{0.0, usual.wheelDiameter, track, 0.0, radius};
    return vehicle;
}

void fitDefaultAxles(Vehicle& vehicle)
{
    const Vehicle usual = defaultVehicle(vehicle.category);
    const double scale = vehicle.box.lengthM / usual.box.lengthM;
    const double middle = vehicle.box.centre.x - usual.box.centre.x * scale; // of the rear axle
    const auto fitted = [&](Axle axle)
    {
        axle.positionXM = middle + axle.positionXM * scale;
        axle.wheelDiameterM *= scale;
        axle.positionZM *= scale;
        axle.trackWidthM *= vehicle.box.widthM / usual.box.widthM;
        return axle;
    };
    vehicle.frontAxle = fitted(*usual.frontAxle);
    vehicle.rearAxle = fitted(usual.rearAxle);
}

} // namespace simulation
