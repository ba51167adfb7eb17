// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "simulation/control/flight/RunwayStrip.h"

namespace simulation
{

/// A circuit around a runway, leg by leg: up wind, across it, down wind, base. The final belongs to the
/// landing. It is left-handed, 250 m above the runway; where the ground below it is too high for that it is
/// on the side with the lower ground, and up to 450 m high.
/// Source: Federal Aviation Administration, *Airplane Flying Handbook* (FAA-H-8083-3C), 2021, chapter 8
/// (traffic patterns).
class CircuitPlan
{
public:
    explicit CircuitPlan(const RunwayStrip& runway) : _runway(runway) {}

    /// By the ground below it.
    CircuitPlan(const RunwayStrip& runway, const Ground& ground);

    bool isRightHanded() const { return _side < 0.0; }

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
    double _side = 1.0;       ///< 1: left, -1: right
    double _patternM = 250.0; ///< above the runway
    int _leg = kUpwind;
    double _turnM = 0.0; ///< where the crosswind leg lies along the runway
};

} // namespace simulation
