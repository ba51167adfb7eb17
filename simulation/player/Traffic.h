// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string>

#include "simulation/scenario/Entity.h"
#include "simulation/state/EntityState.h"
#include "simulation/state/EnvironmentState.h"

namespace simulation
{

/// The others in the scene, as they were at the end of the step before. Without a scenario there is nobody.
struct Traffic
{
    std::span<const EntityState> entities{}; ///< in the scenario's order
    std::span<const BoundingBox> boxes{};    ///< of the same; entity's frame
    int own = -1;                            ///< which of them is controlled; -1: none
    const std::map<std::string, std::string>* signalStates =
        nullptr;                                   ///< by the signal's id; null: no signals
    const EnvironmentState* environment = nullptr; ///< of now; null: nothing is said of it
};

} // namespace simulation
