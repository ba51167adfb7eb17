// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <foundation/Result.h>

namespace osgPMObjects::core
{

/// How an object gets from one level to another. Source: paper 004, section 2.2.
enum class SwitchMethod : std::uint8_t
{
    discrete,   ///< at once
    blend,      ///< two levels for a short time, one fading out and one fading in
    alpha,      ///< one level; only the selection's alpha range fades it, its level changes at once
    continuous, ///< at once, for levels so near to each other that it is not seen
    geomorph,   ///< one level, whose vertices move from where the other has them
};

/// How the alphas of a blend run.
enum class BlendProfile : std::uint8_t
{
    /// They sum up to 1. Right for screen doors whose holes complement each other; with blending the background shines
    /// through.
    cross,
    /// The new level fades in over the old one, which stays whole; then that fades out behind the new one, which is whole.
    /// There is always one that is opaque and writes depth. Source: Giegl & Wimmer, "Unpopping" (2007).
    over,
};

struct SwitchSettings
{
    SwitchMethod method = SwitchMethod::blend;
    BlendProfile profile = BlendProfile::over;
    float durationS = 0.5f; ///< of a blend or morph, above 0
    float staggerS = 0.25f; ///< a switch begins up to this much later, by the object's number; at least 0

    bool operator==(const SwitchSettings&) const = default;
};

/// Whether a switch by this method lasts for some frames, instead of none.
inline bool takesTime(SwitchMethod method)
{
    return method == SwitchMethod::blend || method == SwitchMethod::geomorph;
}

/// Whether switches can be made by these settings: else which field is wrong, and what to do. advanceSwitch() trusts them.
foundation::Outcome checkSettings(const SwitchSettings& settings);

/// One object's switch in one view, kept by the caller.
/// Invariant: isSwitchState(). Memory: 16 B.
struct SwitchState
{
    std::uint32_t from = 0, to = 0; ///< levels; the same while nothing is being switched
    float progress = 0.0f;          ///< 0 … 1 from `from` to `to`
    float delayS = kNotWaiting;     ///< until the switch that is wanted may begin

    static constexpr float kNotWaiting = -1.0f;

    bool isSwitching() const { return from != to; }

    /// At rest at a level: when the object comes into sight, for nobody saw what it was before.
    static SwitchState at(std::uint32_t level) { return {level, level, 0.0f, kNotWaiting}; }
};

bool isSwitchState(const SwitchState& state);

/// A level and how opaque it is drawn.
struct DrawnLevel
{
    std::uint32_t level = 0;
    float alpha = 0.0f;
};

/// What to draw. `second` is drawn only with an alpha above 0, over the first.
struct DrawnLevels
{
    DrawnLevel first, second;
    /// Geomorph: `first` is the finer level, `coarser` the one that it morphs to; 0: its vertices lie where they are, 1:
    /// where the coarser level has them.
    float morph = 0.0f;
    std::uint32_t coarser = 0;

    bool isDrawn() const { return first.alpha > 0.0f || second.alpha > 0.0f; }
};

/// One time step of an object's switch towards the level that selection has chosen, and what to draw then.
/// A switch that has begun is finished before the next one begins, unless the target is the level that it came from: then
/// it runs back from where it is. So no more than two levels are ever drawn, and with time steps of dt no alpha and no
/// morph changes by more than 2·dt/duration (`over`), dt/duration (`cross`, geomorph) in a step: what is left of a step
/// when a switch ends is not spent on the next. `alpha`: of the alpha range; 0: nothing is drawn, and the object is at
/// rest at its target. `number`: the object's, for staggering.
/// Deterministic: no clock, no chance.
DrawnLevels advanceSwitch(SwitchState& state, std::uint32_t target, float stepS, float alpha,
                          std::uint32_t number, const SwitchSettings& settings);

/// The share of the stagger that an object waits, 0 to below 1: spread evenly, and unlike for neighbouring numbers.
float staggerShare(std::uint32_t number);

} // namespace osgPMObjects::core
