// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace simulation
{

/// Time as a whole number of equal steps: no sum of fractions, so no drift, and two runs agree to the last
/// bit. Invariant: seconds() is the double nearest to step·(1/stepsPerSecond), whatever came before. Units:
/// steps, seconds.
class FixedClock
{
public:
    explicit FixedClock(std::int64_t stepsPerSecond) : _stepsPerSecond(stepsPerSecond) {}

    /// A clock that steps a whole number of times per picture, at least `minimumRate` times per second.
    static FixedClock forFrameRate(std::int64_t framesPerSecond, std::int64_t minimumRate = 100)
    {
        return FixedClock(framesPerSecond * ((minimumRate + framesPerSecond - 1) / framesPerSecond));
    }

    void advance() { ++_step; }

    std::int64_t step() const { return _step; }
    std::int64_t stepsPerSecond() const { return _stepsPerSecond; }
    double seconds() const { return secondsAt(_step); }
    double secondsAt(std::int64_t step) const
    {
        return static_cast<double>(step) / static_cast<double>(_stepsPerSecond);
    }

private:
    std::int64_t _stepsPerSecond;
    std::int64_t _step = 0;
};

} // namespace simulation
