// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace simulation
{

/// Tells how many fixed steps are due at a reading of a wall clock, so that simulated time follows it at a
/// chosen rate.
///
/// The steps are always whole and of one length: when pictures are drawn decides how many are made at once,
/// never what they compute. Pictures show timeS(), which lies in or at the end of the last step made. A gap
/// between two readings longer than `mostGapS` (a suspended machine, a machine too slow) is cut to that; what
/// is cut is counted, not caught up.
/// Invariant: (steps() - 1)·stepS < timeS() <= steps()·stepS, or both 0. Units: seconds. Threads: one.
class RealTimePace
{
public:
    explicit RealTimePace(double stepS, double mostGapS = 1.0) : _stepS(stepS), _mostGapS(mostGapS) {}

    /// Takes a reading of the wall clock, the first one as its start, and returns the steps that are due. One
    /// that is not finite or before the last counts as no time.
    std::int64_t advance(double wallS);

    /// A pause ends the step that pictures are in.
    void setPaused(bool isPaused);

    /// Makes one step at the next reading; pauses.
    void stepOnce();

    /// Simulated seconds in one of the wall clock, kRates' least to most.
    void setRate(double rate);
    void slower();
    void faster();

    /// Begins at time 0 again; rate and pause stay.
    void reset();

    bool isPaused() const { return _isPaused; }
    double rate() const { return _rate; }
    double timeS() const { return _timeS; }
    std::int64_t steps() const { return _steps; }

    /// How far timeS() is into the last step, above 0 to 1.
    double share() const;

    /// Wall time so far, without pauses and with what was cut; and what was cut of it.
    double wallS() const { return _wallS; }
    double cutS() const { return _cutS; }

    static constexpr double kSlowest = 1.0 / 16.0, kFastest = 16.0;

private:
    double passedS(double wallS);

    double _stepS, _mostGapS;
    double _rate = 1.0, _timeS = 0.0, _wallS = 0.0, _cutS = 0.0, _lastWallS = 0.0;
    bool _isPaused = false, _hasBegun = false;
    std::int64_t _steps = 0, _asked = 0;
};

} // namespace simulation
