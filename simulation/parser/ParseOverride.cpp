// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

std::optional<ControlOverride> parsePedal(const ElementReader& parent, const char* name)
{
    const pugi::xml_node node = parent.node.child(name);
    if (!node) return std::nullopt;
    ElementReader reader(parent.context, node);
    reader.allowChildren({});
    return ControlOverride{reader.flagOr("active", false),
                           std::clamp(reader.numberOr("value", 0.0), 0.0, 1.0), false};
}

/// From 1.2 on the value stands in BrakePercent (a share up to 1, or above it per cent) or BrakeForce
/// (newtons).
std::optional<ControlOverride> parseBrake(const ElementReader& parent, const char* name)
{
    const pugi::xml_node node = parent.node.child(name);
    if (!node) return std::nullopt;
    ElementReader reader(parent.context, node);
    reader.allowChildren({"BrakePercent", "BrakeForce"});
    ControlOverride brake{reader.flagOr("active", false), std::clamp(reader.numberOr("value", 0.0), 0.0, 1.0),
                          false};
    if (const pugi::xml_node percent = node.child("BrakePercent"))
    {
        const double value = ElementReader(parent.context, percent).notNegative("value");
        brake.value = std::min(value > 1.0 ? 0.01 * value : value, 1.0);
    }
    if (const pugi::xml_node force = node.child("BrakeForce"))
        brake = {brake.isActive, ElementReader(parent.context, force).notNegative("value"), true};
    return brake;
}

GearLever leverOf(double number)
{
    return number > 0.0 ? GearLever::forward : number < 0.0 ? GearLever::reverse : GearLever::neutral;
}

/// 1.0: the number stands in Gear itself.
std::optional<GearOverride> parseGear(const ElementReader& parent)
{
    const pugi::xml_node node = parent.node.child("Gear");
    if (!node) return std::nullopt;
    ElementReader reader(parent.context, node);
    reader.allowChildren({"ManualGear", "AutomaticGear"});
    GearOverride gear{reader.flagOr("active", false), leverOf(reader.numberOr("number", 1.0))};
    if (const pugi::xml_node manual = node.child("ManualGear"))
        gear.lever = leverOf(ElementReader(parent.context, manual).number("number"));
    if (const pugi::xml_node automatic = node.child("AutomaticGear"))
        gear.lever = ElementReader(parent.context, automatic).choice("gear", kGearLevers);
    return gear;
}

} // namespace

OverrideAction parseOverride(ElementReader reader)
{
    reader.allowChildren({"Throttle", "Brake", "Clutch", "ParkingBrake", "SteeringWheel", "Gear"});
    OverrideAction action;
    action.source = reader.context.line(reader.node);
    action.throttle = parsePedal(reader, "Throttle");
    action.brake = parseBrake(reader, "Brake");
    action.clutch = parsePedal(reader, "Clutch");
    action.parkingBrake = parseBrake(reader, "ParkingBrake");
    action.gear = parseGear(reader);
    return action;
}

} // namespace simulation
