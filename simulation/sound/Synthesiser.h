// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "simulation/sound/SoundState.h"

namespace simulation
{

/// Makes the sound of a vehicle from its state: harmonics of engine and propeller, filtered noise of wind and
/// tyres, a stall horn, bumps, clicks of the indicators' relay, and other vehicles by distance (1/r from 1 m)
/// and Doppler shift. Nothing is recorded.
/// Frame: two channels, left first, at kRate a second, within -1…1. Determinism: the same states give the
/// same samples. Threads: one.
/// Sources: Farnell, *Designing Sound*, 2010, practicals 19 (engines) and 25 (wind, filtered noise); for the
/// Doppler shift of a moving source Pierce,
/// *Acoustics*, 1989, section 9-1.
class Synthesiser
{
public:
    static constexpr int kRate = 44'100;
    static constexpr double kSoundMps = 340.0;

    /// Fills `samples` (left, right, left, …) with the time that leads to `state`: frequencies and levels go
    /// there from the last state.
    void render(const SoundState& state, std::span<float> samples);

private:
    /// A tone with harmonics.
    struct Voice
    {
        double phase = 0.0; ///< turns
        double hz = 0.0, level = 0.0;
    };
    struct PassingVoice
    {
        Voice engine;
        double left = 0.5;
        double noise = 0.0; ///< low-passed
        bool isHeard = true;
    };
    /// All that goes smoothly from state to state.
    struct Levels
    {
        double engineHz = 0.0, engine = 0.0, rough = 0.0, propellerHz = 0.0, propeller = 0.0, wind = 0.0,
               windHz = 400.0, roll = 0.0, rollHz = 300.0, squeal = 0.0, horn = 0.0;
    };

    static Levels levelsOf(const SoundState& state);
    double noise();
    double lowPassed(double& kept, double hz);
    double ownSample(const Levels& now);
    void beginEvents(const SoundState& state);
    double eventSample();
    void addPassing(const SoundState& state, std::span<float> samples);

    Levels _levels;
    bool _hasBegun = false, _wasLit = false;
    std::uint32_t _seed = 0x2545F491U;
    double _engineTurn = 0.0, _propellerTurn = 0.0, _hornTurn = 0.0, _squealTurn = 0.0;
    double _windKept = 0.0, _rollKept = 0.0, _roughKept = 0.0, _bumpKept = 0.0;
    double _bump = 0.0, _click = 0.0, _clickTurn = 0.0; ///< what is left of the last ones
    std::map<std::uint64_t, PassingVoice> _passing;
};

} // namespace simulation
