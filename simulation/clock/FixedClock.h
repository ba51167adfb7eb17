// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace simulation
{

/// A clock that counts whole steps of equal length. It adds no fractions, so it does not drift, and two runs
/// agree to the last bit. Invariant: seconds() is the double nearest to step·stepS(). Units: steps, seconds.
class FixedClock
{
public:
    explicit FixedClock(std::int64_t stepsPerSecond) : _stepsPerSecond(stepsPerSecond) {}

    /// Makes a clock with a whole number of steps per frame, and at least `minimumRate` steps per second.
    static FixedClock forFrameRate(std::int64_t framesPerSecond, std::int64_t minimumRate = 100)
    {
        return FixedClock(framesPerSecond * ((minimumRate + framesPerSecond - 1) / framesPerSecond));
    }

    /// Makes a clock whose step has a given length, to the nearest microsecond; at least one.
    static FixedClock forStep(double seconds)
    {
        const std::int64_t micros = std::max<std::int64_t>(std::llround(seconds * 1e6), 1);
        const std::int64_t common = std::gcd(micros, std::int64_t{1'000'000});
        FixedClock clock(1'000'000 / common);
        clock._secondsPerRound = micros / common;
        return clock;
    }

    void advance() { ++_step; }

    /// The same clock at its start.
    FixedClock anew() const
    {
        FixedClock clock(*this);
        clock._step = 0;
        return clock;
    }

    std::int64_t step() const { return _step; }
    /// Steps in a second. Not for a clock of forStep(), whose second may be no whole number of steps.
    std::int64_t stepsPerSecond() const { return _stepsPerSecond; }
    double stepS() const { return secondsAt(1); }
    double seconds() const { return secondsAt(_step); }
    double secondsAt(std::int64_t step) const
    {
        return static_cast<double>(step * _secondsPerRound) / static_cast<double>(_stepsPerSecond);
    }

private:
    std::int64_t _stepsPerSecond;
    std::int64_t _secondsPerRound = 1; ///< that _stepsPerSecond steps take
    std::int64_t _step = 0;
};

} // namespace simulation
