// SPDX-License-Identifier: Apache-2.0
#include "simulation/sound/Synthesiser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace simulation
{

namespace
{

constexpr double kStepS = 1.0 / Synthesiser::kRate;
// Levels of the loudest of each, found by ear of the spectrum: their sum stays within the range at full
// power.
constexpr double kEngine = 0.16, kPropeller = 0.14, kWind = 0.16, kRoll = 0.12, kSqueal = 0.10, kHorn = 0.10,
                 kBump = 0.5, kClick = 0.12, kPassing = 0.8;
constexpr double kBumpHz = 70.0, kBumpS = 0.09, kClickHz = 2600.0, kClickS = 0.006, kHornHz = 740.0,
                 kSquealHz = 980.0;

double sine(double turns)
{
    return std::sin(2.0 * std::numbers::pi * turns);
}

void advance(double& turns, double hz)
{
    turns += hz * kStepS;
    turns -= std::floor(turns);
}

/// A tone with the harmonics of pulses: the first is the strongest.
double pulses(double turns)
{
    return 0.62 * sine(turns) + 0.30 * sine(2.0 * turns) + 0.16 * sine(3.0 * turns) +
           0.08 * sine(4.0 * turns);
}

/// How loud tyres are on a ground, and the edge of their noise.
struct TyreTone
{
    double loudness, hz;
};

TyreTone toneOf(TyreSound tyres)
{
    switch (tyres)
    {
    case TyreSound::hard:
        return {0.55, 700.0};
    case TyreSound::wet:
        return {0.8, 3200.0};
    case TyreSound::loose:
        return {1.0, 1800.0};
    case TyreSound::soft:
        return {0.4, 220.0};
    default:
        return {0.0, 700.0};
    }
}

template<class Value>
Value mixed(const Value& from, const Value& to, double share)
{
    return from + share * (to - from);
}

} // namespace

Synthesiser::Levels Synthesiser::levelsOf(const SoundState& state)
{
    Levels levels;
    const double load = std::clamp(state.engineLoad, 0.0, 1.0);
    levels.engineHz = std::clamp(state.engineHz, 0.0, 2000.0);
    levels.engine = levels.engineHz > 1.0 ? kEngine * (0.35 + 0.65 * load) : 0.0;
    levels.rough = levels.engine * 0.25;
    levels.propellerHz = std::clamp(state.propellerHz, 0.0, 1000.0);
    levels.propeller = levels.propellerHz > 1.0
                           ? kPropeller * std::min(1.0, levels.propellerHz / 90.0) * (0.5 + 0.5 * load)
                           : 0.0;
    const double air = std::clamp(state.airspeedMps / 80.0, 0.0, 1.5);
    levels.wind = kWind * air * air;
    levels.windHz = 250.0 + 900.0 * air;
    const TyreTone tone = toneOf(state.tyres);
    const double rolling = std::clamp(std::abs(state.rollingMps) / 35.0, 0.0, 1.0);
    levels.roll = kRoll * tone.loudness * rolling;
    levels.rollHz = tone.hz;
    const bool isHard = state.tyres == TyreSound::hard;
    levels.squeal = isHard && std::abs(state.rollingMps) > 1.0
                        ? kSqueal * std::clamp(2.0 * (state.tyreSlip - 0.9), 0.0, 1.0)
                        : 0.0;
    levels.horn = kHorn * std::clamp(state.stallHorn, 0.0, 1.0);
    return levels;
}

/// White, by xorshift (Marsaglia, 2003).
double Synthesiser::noise()
{
    _seed ^= _seed << 13;
    _seed ^= _seed >> 17;
    _seed ^= _seed << 5;
    return static_cast<double>(_seed) / 2147483648.0 - 1.0;
}

/// Noise through a filter of one pole, about as loud for every edge.
double Synthesiser::lowPassed(double& kept, double hz)
{
    const double share = 1.0 - std::exp(-2.0 * std::numbers::pi * hz * kStepS);
    kept += share * (noise() - kept);
    return kept * std::sqrt((2.0 - share) / share);
}

double Synthesiser::ownSample(const Levels& now)
{
    advance(_engineTurn, now.engineHz);
    advance(_propellerTurn, now.propellerHz);
    advance(_hornTurn, kHornHz);
    advance(_squealTurn, kSquealHz);
    double sum = now.engine * pulses(_engineTurn) + now.propeller * pulses(_propellerTurn);
    // Each firing is rough.
    sum += now.rough * lowPassed(_roughKept, 900.0) * (0.5 + 0.5 * sine(_engineTurn));
    sum += now.wind * lowPassed(_windKept, now.windHz) + now.roll * lowPassed(_rollKept, now.rollHz);
    sum += now.horn * (sine(_hornTurn) > 0.0 ? 0.7 : -0.7) + now.squeal * pulses(_squealTurn);
    return sum;
}

void Synthesiser::beginEvents(const SoundState& state)
{
    if (state.bumpMps > 0.1) _bump = std::max(_bump, kBump * std::min(1.0, state.bumpMps / 3.0));
    if (_hasBegun && state.isIndicatorLit != _wasLit)
    {
        _click = kClick;
        _clickTurn = 0.0;
    }
    _wasLit = state.isIndicatorLit;
}

double Synthesiser::eventSample()
{
    _bump *= std::exp(-kStepS / kBumpS);
    _click *= std::exp(-kStepS / kClickS);
    advance(_clickTurn, kClickHz);
    if (_bump < 1e-5 && _click < 1e-5) return 0.0;
    return _bump * lowPassed(_bumpKept, kBumpHz) + _click * sine(_clickTurn);
}

/// A source that recedes at v is heard at f c / (c + v).
void Synthesiser::addPassing(const SoundState& state, std::span<float> samples)
{
    for (auto& [id, voice] : _passing)
        voice.isHeard = false;
    const std::size_t frames = samples.size() / 2;
    for (const PassingSound& source : state.passing)
    {
        const bool isNew = !_passing.contains(source.id);
        PassingVoice& voice = _passing[source.id];
        voice.isHeard = true;
        const double hz =
            source.engineHz * kSoundMps / (kSoundMps + std::clamp(source.recedingMps, -200.0, 200.0));
        const double level =
            kPassing * source.loudness * std::min(1.0, 1.0 / std::max(source.distanceM, 1.0));
        const double left = 0.5 + 0.5 * std::clamp(source.leftShare, -1.0, 1.0);
        const PassingVoice before = isNew ? PassingVoice{{0.0, hz, level}, left, 0.0, true} : voice;
        for (std::size_t i = 0; i < frames; ++i)
        {
            const double share = (static_cast<double>(i) + 1.0) / static_cast<double>(frames);
            advance(voice.engine.phase, mixed(before.engine.hz, hz, share));
            const double tone = 0.7 * pulses(voice.engine.phase) + 0.12 * lowPassed(voice.noise, 600.0);
            const double sample = mixed(before.engine.level, level, share) * tone;
            const double side = mixed(before.left, left, share);
            samples[2 * i] += static_cast<float>(sample * std::sqrt(side));
            samples[2 * i + 1] += static_cast<float>(sample * std::sqrt(1.0 - side));
        }
        voice.engine.hz = hz;
        voice.engine.level = level;
        voice.left = left;
    }
    std::erase_if(_passing, [](const auto& voice) { return !voice.second.isHeard; });
}

void Synthesiser::render(const SoundState& state, std::span<float> samples)
{
    const Levels to = levelsOf(state);
    const Levels from = _hasBegun ? _levels : to;
    beginEvents(state);
    const std::size_t frames = samples.size() / 2;
    for (std::size_t i = 0; i < frames; ++i)
    {
        const double share = (static_cast<double>(i) + 1.0) / static_cast<double>(frames);
        Levels now;
        now.engineHz = mixed(from.engineHz, to.engineHz, share);
        now.engine = mixed(from.engine, to.engine, share);
        now.rough = mixed(from.rough, to.rough, share);
        now.propellerHz = mixed(from.propellerHz, to.propellerHz, share);
        now.propeller = mixed(from.propeller, to.propeller, share);
        now.wind = mixed(from.wind, to.wind, share);
        now.windHz = mixed(from.windHz, to.windHz, share);
        now.roll = mixed(from.roll, to.roll, share);
        now.rollHz = mixed(from.rollHz, to.rollHz, share);
        now.squeal = mixed(from.squeal, to.squeal, share);
        now.horn = mixed(from.horn, to.horn, share);
        samples[2 * i] = samples[2 * i + 1] = static_cast<float>(ownSample(now) + eventSample());
    }
    addPassing(state, samples);
    for (float& sample : samples)
        sample = std::clamp(sample, -1.0F, 1.0F);
    _levels = to;
    _hasBegun = true;
}

} // namespace simulation
