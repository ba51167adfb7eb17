// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <foundation/SettingsCheck.h>

#include <osgPMObjects/core/selection/Switch.h>

namespace osgPMObjects::core
{

namespace
{

/// Begins a switch, reverses one, or waits for its delay; it does not advance a running switch.
void aim(SwitchState& state, std::uint32_t target, float stepS, float stagger)
{
    if (state.isSwitching())
    {
        if (target != state.from) return;
        std::swap(state.from, state.to);
        state.progress = 1.0f - state.progress;
        return;
    }
    if (target == state.from)
    { // the wanted switch was cancelled before it began: the next one waits again
        state.delayS = SwitchState::kNotWaiting;
        return;
    }
    if (state.delayS == SwitchState::kNotWaiting) state.delayS = stagger;
    state.delayS -= stepS;
    if (state.delayS > 0.0f) return;
    state = {state.from, target, 0.0f, SwitchState::kNotWaiting};
}

DrawnLevels blended(const SwitchState& state, const SwitchSettings& settings, float alpha)
{
    if (settings.profile == BlendProfile::cross)
        return {{state.from, alpha * (1.0f - state.progress)}, {state.to, alpha * state.progress}, 0.0f, 0};
    // The opaque level comes first, so that the other is blended with it, not with the background.
    if (state.progress < 0.5f)
        return {{state.from, alpha}, {state.to, alpha * 2.0f * state.progress}, 0.0f, 0};
    return {{state.to, alpha}, {state.from, alpha * 2.0f * (1.0f - state.progress)}, 0.0f, 0};
}

DrawnLevels morphed(const SwitchState& state, float alpha)
{
    const bool getsFiner = state.to < state.from; // fewer steps
    DrawnLevels drawn;
    drawn.first = {std::min(state.from, state.to), alpha};
    drawn.morph = getsFiner ? 1.0f - state.progress : state.progress;
    drawn.coarser = std::max(state.from, state.to);
    return drawn;
}

DrawnLevels atRest(std::uint32_t level, float alpha)
{
    DrawnLevels drawn;
    drawn.first = {level, alpha};
    drawn.coarser = level;
    return drawn;
}

} // namespace

foundation::Outcome checkSettings(const SwitchSettings& settings)
{
    return foundation::SettingsCheck("switching")
        .above("durationS", settings.durationS, 0.0)
        .within("staggerS", settings.staggerS, 0.0)
        .outcome();
}

bool isSwitchState(const SwitchState& state)
{
    return state.progress >= 0.0f && state.progress < 1.0f && (state.isSwitching() || state.progress == 0.0f);
}

float staggerShare(std::uint32_t number)
{
    // A multiplicative hash (Knuth, The Art of Computer Programming 3, 6.4): neighbours differ by the golden
    // ratio.
    return static_cast<float>((number * 2654435769u) >> 8) * 0x1p-24f;
}

DrawnLevels advanceSwitch(SwitchState& state, std::uint32_t target, float stepS, float alpha,
                          std::uint32_t number, const SwitchSettings& settings)
{
    const float stagger = settings.staggerS * staggerShare(number);
    if (!takesTime(settings.method) || alpha <= 0.0f)
    {
        state = SwitchState::at(target);
        return atRest(target, alpha);
    }
    const bool wasSwitching = state.isSwitching();
    aim(state, target, stepS, stagger);
    if (!state.isSwitching()) return atRest(state.from, alpha);
    // The rest of the step after the delay is short; the switch begins with the next step.
    if (wasSwitching) state.progress += stepS / settings.durationS;
    if (state.progress >= 1.0f)
    {
        state = SwitchState::at(state.to);
        return atRest(state.to, alpha);
    }
    return settings.method == SwitchMethod::blend ? blended(state, settings, alpha) : morphed(state, alpha);
}

} // namespace osgPMObjects::core
