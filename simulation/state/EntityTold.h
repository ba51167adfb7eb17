// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace simulation
{

/// What a table tells of an entity in a play with a person in it, besides the state.
struct EntityTold
{
    std::string drivenBy = "scenario"; ///< or person, or the kind of the controller with physics

    /// The hardest impact that began in this step. Units: m/s, radians from east, counter-clockwise.
    struct Blow
    {
        double speedMps = 0.0;   ///< of the vehicle, before
        double closingMps = 0.0; ///< of both against each other
        double courseRad = 0.0;  ///< of the vehicle's motion, before
        std::string with;        ///< what was hit
    };
    std::optional<Blow> blow{};
};

} // namespace simulation
