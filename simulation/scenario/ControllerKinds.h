// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace simulation
{

/// Who moves an entity while a controller is active.
enum class ControllerRole
{
    actions, ///< those of the scenario, as without a controller
    person,  ///< one who sits in the entity
    speed,   ///< the controller its speed, actions all else
    vehicle, ///< the controller, by a vehicle with physics
};

/// A kind of controller, by the names that scenarios give it.
struct ControllerKind
{
    std::string_view name; ///< as pages and messages have it
    ControllerRole role = ControllerRole::actions;
    std::span<const std::string_view> otherNames{};
    bool goesByRoads = false;         ///< along the scenario's roads, where there are some
    bool standsWithoutPerson = false; ///< where nobody sits the entity stands still, else actions move it
};

/// All kinds that are played, each once, by their names.
std::span<const ControllerKind> controllerKinds();

/// The kind that has a name, other ones included; null: none has.
const ControllerKind* findControllerKind(std::string_view name);

/// The names of all kinds, parted by commas, for messages.
std::string controllerNames();

} // namespace simulation
