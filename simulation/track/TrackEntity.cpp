// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackEntity.h"

namespace simulation
{
namespace
{

Vehicle vehicle(const std::string& category, const BoundingBox& box, double speedMps)
{
    Vehicle vehicle;
    vehicle.name = category;
    vehicle.category = category;
    vehicle.box = box;
    vehicle.performance = {speedMps, 100.0, 100.0};
    return vehicle;
}

Vehicle recordedCar()
{
    Vehicle made = vehicle("car", {{1.35, 0.0, 0.75}, 4.4, 1.8, 1.5}, 100.0);
    made.frontAxle = Axle{0.6, 0.66, 1.54, 2.65, 0.33};
    made.rearAxle = Axle{0.0, 0.66, 1.54, 0.0, 0.33};
    return made;
}

MiscObject thing(const std::string& name, const BoundingBox& box)
{
    MiscObject made;
    made.name = name;
    made.category = "none";
    made.massKg = 1000.0;
    made.box = box;
    return made;
}

std::variant<Vehicle, Pedestrian, MiscObject, Unsupported> bodyOf(TrackKind kind)
{
    switch (kind)
    {
    case TrackKind::aircraft:
        return vehicle("aircraft", {{0.0, 0.0, 1.4}, 8.1, 11.0, 2.75}, 1000.0);
    case TrackKind::helicopter:
        return vehicle("helicopter", {{-1.5, 0.0, 1.6}, 11.0, 2.2, 3.2}, 200.0);
    case TrackKind::person:
    {
        Pedestrian person;
        person.name = person.category = "pedestrian";
        person.massKg = 80.0;
        person.box = {{0.0, 0.0, 0.875}, 0.5, 0.6, 1.75};
        return person;
    }
    case TrackKind::ship:
        return thing("ship", {{0.0, 0.0, 7.0}, 120.0, 16.0, 14.0});
    case TrackKind::thing:
    {
        MiscObject flying = thing("object", {{0.0, 0.0, 0.15}, 3.0, 0.3, 0.3});
        flying.properties.values = {{"domain", "air"}};
        return flying;
    }
    default:
        return recordedCar();
    }
}

} // namespace

ScenarioObject entityOf(TrackKind kind, const std::string& name)
{
    ScenarioObject entity;
    entity.name = name;
    entity.object = bodyOf(kind);
    return entity;
}

double defaultSpeedMps(TrackKind kind)
{
    if (kind == TrackKind::aircraft) return 50.0;
    if (kind == TrackKind::helicopter) return 40.0;
    return kind == TrackKind::person ? 1.4 : 14.0;
}

} // namespace simulation
