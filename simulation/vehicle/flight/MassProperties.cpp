// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/MassProperties.h"

namespace simulation
{

namespace
{

glm::dmat3 inertiaOfPoint(double massKg, const glm::dvec3& arm)
{
    return massKg * (glm::dmat3(glm::dot(arm, arm)) - glm::outerProduct(arm, arm));
}

} // namespace

MassProperties massProperties(const AircraftData& aircraft, std::span<const double> fuelKg)
{
    const auto forEachPoint = [&](const auto& visit)
    {
        visit(aircraft.empty.massKg, aircraft.empty.place);
        for (const MassPoint& load : aircraft.loads)
            visit(load.massKg, load.place);
        for (std::size_t i = 0; i < aircraft.tanks.size() && i < fuelKg.size(); ++i)
            visit(fuelKg[i], aircraft.tanks[i].place);
    };
    MassProperties mass;
    forEachPoint(
        [&](double massKg, const glm::dvec3& place)
        {
            mass.massKg += massKg;
            mass.centre += massKg * place;
        });
    mass.centre /= mass.massKg;
    mass.inertia = aircraft.emptyInertia;
    forEachPoint([&](double massKg, const glm::dvec3& place)
                 { mass.inertia += inertiaOfPoint(massKg, bodyPlace(place, mass.centre)); });
    mass.inverse = glm::inverse(mass.inertia);
    return mass;
}

} // namespace simulation
