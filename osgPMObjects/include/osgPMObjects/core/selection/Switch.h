// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <foundation/Result.h>

namespace osgPMObjects::core
{

/// The way in which an object changes from one level to another. Source: Sadykov & Zakharov, *Choosing the
/// level of detail in continuous simplification of polygonal objects* (2002), section 2.2.
enum class SwitchMethod : std::uint8_t
{
    discrete,   ///< at once
    blend,      ///< both levels are drawn for a short time, one fading out and one fading in
    alpha,      ///< at once; the object fades by its AlphaRange only
    continuous, ///< at once, for levels so similar that the change is not visible
    geomorph,   ///< one level is drawn, whose vertices move from their positions in the other level
};

/// The alphas of the two levels of a blend over time.
enum class BlendProfile : std::uint8_t
{
    /// The alphas sum up to 1. It suits screen doors with complementary holes; with alpha blending the
    /// background shows through.
    cross,
    /// The new level fades in over the old one, which stays opaque; then the old one fades out behind the new
    /// one. One level is opaque and writes depth at any time. Source: Giegl & Wimmer, "Unpopping" (2007).
    over,
};

struct SwitchSettings
{
    SwitchMethod method = SwitchMethod::blend;
    BlendProfile profile = BlendProfile::over;
    float durationS = 0.5f; ///< of a blend or morph; above 0, finite
    float staggerS = 0.25f; ///< longest delay of a switch, spread by the object's number; at least 0, finite

    bool operator==(const SwitchSettings&) const = default;
};

/// Tells whether a switch by this method lasts for several frames.
inline bool takesTime(SwitchMethod method)
{
    return method == SwitchMethod::blend || method == SwitchMethod::geomorph;
}

/// Tells whether switches can be made by these settings: else an error that names the field. advanceSwitch()
/// does not check.
foundation::Outcome checkSettings(const SwitchSettings& settings);

/// The state of one object's switch in one view, kept by the caller.
/// Invariant: isSwitchState(). Memory: 16 B.
struct SwitchState
{
    std::uint32_t from = 0, to = 0; ///< levels; equal while no switch runs
    float progress = 0.0f;          ///< 0 … 1 from `from` to `to`
    float delayS = kNotWaiting;     ///< time until a wanted switch may begin

    static constexpr float kNotWaiting = -1.0f;

    bool isSwitching() const { return from != to; }

    /// Returns the state at rest at a level, for an object that becomes visible: its last level was not seen.
    static SwitchState at(std::uint32_t level) { return {level, level, 0.0f, kNotWaiting}; }
};

bool isSwitchState(const SwitchState& state);

/// A level and the alpha with which it is drawn.
struct DrawnLevel
{
    std::uint32_t level = 0;
    float alpha = 0.0f;
};

/// The levels to draw of one object. `second` is drawn over `first`, if its alpha is above 0.
struct DrawnLevels
{
    DrawnLevel first, second;
    /// Geomorph: `first` is the finer level, `coarser` the other one. 0: vertices have their own positions;
    /// 1: those that they have in the coarser level.
    float morph = 0.0f;
    std::uint32_t coarser = 0;

    bool isDrawn() const { return first.alpha > 0.0f || second.alpha > 0.0f; }
};

/// Advances one object's switch by a time step towards the level that selection has chosen; returns the
/// levels to draw. A switch that has begun finishes before the next one begins; only if the target is the
/// level that it came from, it runs back. So at most two levels are drawn. In a step of dt no alpha or morph
/// changes by more than 2·dt/duration (`over`) or dt/duration (`cross`, geomorph): the rest of a step in
/// which a switch ends is not used for the next switch.
/// `alpha`: of the alpha range; 0: nothing is drawn, and the object rests at its target. `number`: the
/// object's, for the stagger. Deterministic: no clock, no random numbers.
DrawnLevels advanceSwitch(SwitchState& state, std::uint32_t target, float stepS, float alpha,
                          std::uint32_t number, const SwitchSettings& settings);

/// Returns an object's share of the stagger, 0 to below 1: evenly spread, different for neighbouring numbers.
float staggerShare(std::uint32_t number);

} // namespace osgPMObjects::core
