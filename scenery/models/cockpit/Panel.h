// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include <glm/vec2.hpp>

#include "scenery/models/cockpit/Dial.h"

namespace scenery::models
{

/// Each instrument of the cockpit and of the car, in the order of the cells of the picture `instruments`.
enum class Instrument
{
    airspeed,
    altimeter,
    turn,
    heading,
    climb,
    tachometer,
    fuelLeft,
    fuelRight,
    flaps,
    trim,
    speedometer,
    revs,
    fuel,
    dials,            ///< how many are dials
    attitude = dials, ///< a ball (AttitudeBall.h)
    digits,           ///< a drum of figures (Drum.h)
    count
};

/// The dial of an instrument that is one.
const Dial& dialOf(Instrument instrument);

/// An instrument and its place on a panel. Frame: the panel's as it is looked at, x to the right, y up, from
/// the eye's foot on it.
/// Units: metres.
struct PlacedInstrument
{
    Instrument instrument = Instrument::airspeed;
    glm::dvec2 middle{0.0};
    double radiusM = 0.04;
};

std::span<const PlacedInstrument> aircraftPanel();
std::span<const PlacedInstrument> carPanel();

} // namespace scenery::models
