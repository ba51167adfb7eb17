// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "simulation/vehicle/flight/GroundContacts.h"

namespace simulation
{

/// How far propeller and wheels have turned, for pictures alone: nothing of it comes back into the motion.
class WheelTurns
{
public:
    explicit WheelTurns(const AircraftData& aircraft) : _wheels(aircraft.contacts.size()) {}

    /// Turns wheels by one step: with the ground where they touch it, and slower and slower in the air.
    /// `speedMps`: of the aircraft along itself.
    void step(const AircraftData& aircraft, std::span<const Contact> contacts, double speedMps,
              double propellerRadps, double stepS);

    /// Degrees, 0…360; wheels by the index of the contact.
    double wheelDeg(std::size_t contact) const { return _wheels[contact].turnDeg; }
    double propellerDeg() const { return _propellerDeg; }

private:
    struct Wheel
    {
        double turnDeg = 0.0;
        double radps = 0.0;
    };

    std::vector<Wheel> _wheels;
    double _propellerDeg = 0.0;
};

} // namespace simulation
