// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

namespace simulation
{

/// Whether one who comes to a line could stop before it only by braking harder than it wants; it passes then.
inline bool comesTooLate(double gapM, double speedMps, double brakesMps2)
{
    constexpr double kCreepsMps = 1.0;
    return speedMps > kCreepsMps && speedMps * speedMps > 2.0 * brakesMps2 * gapM;
}

/// The rule at stop signs: one stands before the line, looks for a while, and goes on.
/// Places are metres along a way, in whatever measure the owner uses for all of them.
class StopAtSign
{
public:
    explicit StopAtSign(double lookS = 1.5) : _lookS(lookS) {}

    /// Whether it has stood at the sign whose line lies there.
    bool hasServed(double lineM) const { return _servedM && std::fabs(lineM - *_servedM) < kSameLineM; }

    /// Whether the sign holds one whose front is `gapM` before its line. To be called once in each step of
    /// `stepS`, for the next sign alone.
    bool holds(double lineM, double gapM, double speedMps, double stepS)
    {
        constexpr double kStandingMps = 0.2, kAtLineM = 3.0;
        if (hasServed(lineM)) return false;
        if (speedMps >= kStandingMps || gapM >= kAtLineM) return true;
        _waitedS += stepS;
        if (_waitedS < _lookS) return true;
        _waitedS = 0.0;
        _servedM = lineM;
        return false;
    }

private:
    static constexpr double kSameLineM = 3.0;

    double _lookS;
    double _waitedS = 0.0; ///< at the sign ahead
    std::optional<double> _servedM;
};

} // namespace simulation
