// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/ControllerKinds.h"

#include <algorithm>

#include "simulation/scenario/Entity.h"

namespace simulation
{
namespace
{

constexpr std::string_view kUnnamed[] = {""};
constexpr std::string_view kExternalNames[] = {"externalController", "interactiveDriver",
                                               "InteractiveDriver"}; // of esmini's catalogue
constexpr std::string_view kNaturalNames[] = {"NaturalDriver"};
constexpr std::string_view kManualNames[] = {"ManualController"};

constexpr ControllerKind kKinds[] = {
    {.name = "ACCController", .role = ControllerRole::speed},
    {.name = "Autopilot", .role = ControllerRole::vehicle},
    {.name = "DefaultController", .role = ControllerRole::actions, .otherNames = kUnnamed},
    {.name = "Driver", .role = ControllerRole::vehicle, .goesByRoads = true},
    {.name = "ExternalController", .role = ControllerRole::person, .otherNames = kExternalNames},
    {.name = "IntelligentDriver", .role = ControllerRole::speed, .otherNames = kNaturalNames},
    {.name = "InteractiveController", .role = ControllerRole::person, .standsWithoutPerson = true},
    {.name = "Manual", .role = ControllerRole::person, .otherNames = kManualNames},
    {.name = "RecordedInputs", .role = ControllerRole::vehicle},
};

bool hasRole(const Controller& controller, ControllerRole role)
{
    const ControllerKind* const kind = controller.played();
    return kind && kind->role == role;
}

} // namespace

std::span<const ControllerKind> controllerKinds()
{
    return kKinds;
}

const ControllerKind* findControllerKind(std::string_view name)
{
    const auto* const found = std::find_if(
        std::begin(kKinds), std::end(kKinds),
        [&](const ControllerKind& kind)
        {
            const auto& others = kind.otherNames;
            return kind.name == name || std::find(others.begin(), others.end(), name) != others.end();
        });
    return found == std::end(kKinds) ? nullptr : found;
}

std::string controllerNames()
{
    std::string names;
    for (const ControllerKind& kind : kKinds)
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    return names;
}

const ControllerKind* Controller::played() const
{
    return findControllerKind(kind());
}

bool Controller::isManual() const
{
    return hasRole(*this, ControllerRole::person);
}

bool Controller::hasPhysics() const
{
    return hasRole(*this, ControllerRole::vehicle);
}

} // namespace simulation
