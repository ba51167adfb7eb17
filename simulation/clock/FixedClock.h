// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace simulation
{

/// A clock that counts whole steps of equal length. It adds no fractions, so it does not drift, and two runs agree to
/// the last bit. Invariant: seconds() is the double nearest to step·(1/stepsPerSecond). Units: steps, seconds.
class FixedClock
{
public:
    explicit FixedClock(std::int64_t stepsPerSecond) : _stepsPerSecond(stepsPerSecond) {}

    /// Makes a clock with a whole number of steps per frame, and at least `minimumRate` steps per second.
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
