// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/scenario/LongitudinalActions.h"

namespace simulation
{

/// The speed over time that a SpeedProfileAction asks for.
/// `position`: straight from entry to entry. `follow`: the lines between the entries, joined by parabolas
/// that touch both, on which the acceleration changes at its greatest rate; the first line is reached by a
/// parabola from rest of acceleration, so it lies later. Both as esmini drives them
/// (tests/core/simulation/RecordedScenarioTest.cpp).
/// Units: seconds since the start, m/s.
class SpeedCourse
{
public:
    /// `fromMps`: the speed at the start. An entry without time takes as long as the greatest acceleration
    /// needs.
    SpeedCourse(const SpeedProfileAction& action, double fromMps, double accelerationMps2,
                double decelerationMps2);

    double speedAt(double timeS) const;
    double durationS() const { return _pieces.back().startS; }

private:
    /// From startS on: speed + acceleration·τ + jerk·τ²/2.
    struct Piece
    {
        double startS = 0.0, speedMps = 0.0, accelerationMps2 = 0.0, jerkMps3 = 0.0;

        double at(double timeS) const
        {
            const double time = timeS - startS;
            return speedMps + time * (accelerationMps2 + 0.5 * time * jerkMps3);
        }
    };

    void addSmooth(const std::vector<Piece>& lines, const DynamicConstraints& constraints);

    std::vector<Piece> _pieces; ///< the last one keeps its speed
};

} // namespace simulation
