// SPDX-License-Identifier: Apache-2.0
#include "simulation/clock/RealTimePace.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

namespace
{

constexpr double kSameStep = 1e-9; ///< of a step, by which sums of times may miss its end

} // namespace

/// The wall time since the last reading, cut to the longest gap.
double RealTimePace::passedS(double wallS)
{
    if (!std::isfinite(wallS)) return 0.0;
    const double gapS = _hasBegun ? std::max(0.0, wallS - _lastWallS) : 0.0;
    _hasBegun = true;
    _lastWallS = wallS;
    if (_isPaused) return 0.0;
    _wallS += gapS;
    const double passedS = std::min(gapS, _mostGapS);
    _cutS += gapS - passedS;
    return passedS;
}

std::int64_t RealTimePace::advance(double wallS)
{
    const double passed = passedS(wallS);
    const std::int64_t made = _steps;
    if (_isPaused)
    {
        _steps += _asked;
        _timeS = static_cast<double>(_steps) * _stepS;
    }
    else
    {
        _timeS += _rate * passed;
        _steps = std::max(_steps, static_cast<std::int64_t>(std::ceil(_timeS / _stepS - kSameStep)));
    }
    _asked = 0;
    return _steps - made;
}

void RealTimePace::setPaused(bool isPaused)
{
    _isPaused = isPaused;
    if (isPaused) _timeS = static_cast<double>(_steps) * _stepS;
}

void RealTimePace::stepOnce()
{
    setPaused(true);
    ++_asked;
}

void RealTimePace::setRate(double rate)
{
    if (std::isfinite(rate)) _rate = std::clamp(rate, kSlowest, kFastest);
}

void RealTimePace::slower()
{
    setRate(0.5 * _rate);
}

void RealTimePace::faster()
{
    setRate(2.0 * _rate);
}

void RealTimePace::reset()
{
    _timeS = _wallS = _cutS = 0.0;
    _steps = _asked = 0;
}

double RealTimePace::share() const
{
    if (_steps == 0) return 1.0;
    return std::clamp(_timeS / _stepS - static_cast<double>(_steps - 1), 0.0, 1.0);
}

} // namespace simulation
