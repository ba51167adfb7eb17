// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "simulation/control/flight/RunwayStrip.h"

namespace simulation
{

/// A left-hand circuit around a runway, leg by leg: up wind, across it, down wind, base. The final belongs to the landing.
/// Source: Federal Aviation Administration, *Airplane Flying Handbook* (FAA-H-8083-3C), 2021, chapter 8 (traffic patterns).
class CircuitPlan
{
public:
    explicit CircuitPlan(const RunwayStrip& runway) : _runway(runway) {}

    /// What to fly now.
    struct Leg
    {
        CourseLine line;
        double altitudeM = 0.0;
        double speedMps = 0.0; ///< calibrated
        double flaps = 0.0;    ///< 0…1
        std::string_view name;
    };

    /// Goes on to the next leg where it is time to turn.
    void advance(const FlightSense& sense);

    Leg leg() const;

    /// Whether the base leg has come to the turn onto the final.
    bool isDone() const { return _leg > kBase; }

private:
    enum LegIndex
    {
        kUpwind,
        kCrosswind,
        kDownwind,
        kBase
    };

    RunwayStrip _runway;
    int _leg = kUpwind;
    double _turnM = 0.0; ///< where the crosswind leg lies along the runway
};

} // namespace simulation
