// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include <osgPMObjects/core/selection/Switch.h>

namespace osgPMObjects::core
{

namespace
{

/// Begins a switch, runs one back, or waits for its turn. Does not move one that runs.
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
    { // wanted no more before it began: the next one waits anew
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
    // The opaque one comes first, so that the other is blended with it, not with what is behind both.
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
    if (!std::isfinite(settings.durationS) || settings.durationS <= 0.0f)
        return foundation::Error{"durationS",
                                 "a switch cannot last " + std::to_string(settings.durationS) + " s",
                                 "give a time above 0, or the method discrete"};
    if (!std::isfinite(settings.staggerS) || settings.staggerS < 0.0f)
        return foundation::Error{"staggerS",
                                 "a switch cannot wait " + std::to_string(settings.staggerS) + " s",
                                 "give a time of at least 0"};
    return foundation::success();
}

bool isSwitchState(const SwitchState& state)
{
    return state.progress >= 0.0f && state.progress < 1.0f && (state.isSwitching() || state.progress == 0.0f);
}

float staggerShare(std::uint32_t number)
{
    // A multiplicative hash (Knuth, The Art of Computer Programming 3, 6.4): neighbours are a golden ratio apart.
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
    // What is left of the step after the wait is little; the switch begins with the next.
    if (wasSwitching) state.progress += stepS / settings.durationS;
    if (state.progress >= 1.0f)
    {
        state = SwitchState::at(state.to);
        return atRest(state.to, alpha);
    }
    return settings.method == SwitchMethod::blend ? blended(state, settings, alpha) : morphed(state, alpha);
}

} // namespace osgPMObjects::core
