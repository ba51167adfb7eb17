// SPDX-License-Identifier: Apache-2.0
#include "FieldSwitch.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

namespace
{

InstanceAttributes placed(const FieldModel& model, const FieldObject& object, const glm::dvec3& eye)
{
    const glm::dvec3 position = object.position + object.attitude * (object.scale * model.origin) - eye;
    const glm::dquat& q = object.attitude;
    return {
        {static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z),
         static_cast<float>(object.scale)},
        {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)},
        {0.0f, 1.0f, 0.0f, 0.0f}};
}

} // namespace

DrawnLevels advanceOnLadder(SwitchState& state, std::uint32_t wanted, float stepS, float alpha,
                            std::uint32_t number, const SwitchSettings& settings)
{
    if (settings.method != SwitchMethod::geomorph)
        return advanceSwitch(state, wanted, stepS, alpha, number, settings);
    const std::uint32_t at = state.isSwitching() ? state.to : state.from;
    const auto away = static_cast<float>(wanted > at ? wanted - at : at - wanted);
    std::uint32_t next = wanted;
    if (state.isSwitching())
        next = std::clamp(wanted, std::min(state.from, state.to), std::max(state.from, state.to));
    else if (wanted != at)
        next = wanted > at ? at + 1 : at - 1;
    return advanceSwitch(state, next, stepS * std::max(1.0f, away), alpha, number, settings);
}

void showLevels(FieldSorter& sorter, const Field& field, std::uint32_t object, const DrawnLevels& levels,
                const glm::dvec3& eye)
{
    if (!levels.isDrawn()) return;
    const FieldObject& placement = field.objects()[object];
    const FieldModel& model = field.models()[placement.model];
    InstanceAttributes instance = placed(model, placement, eye);
    const auto show = [&](FieldPass pass, std::uint32_t rung, float from, float to)
    {
        if (to <= from) return;
        instance.transition[0] = from;
        instance.transition[1] = to;
        sorter.add(object, pass, rung, instance);
    };
    if (levels.morph > 0.0f)
    {
        instance.transition[2] = levels.morph;
        instance.transition[3] = static_cast<float>(model.ladder->rungs[levels.coarser].wedges);
        return show(FieldPass::switching, levels.first.level, 0.0f, levels.first.alpha);
    }
    const float first = levels.first.alpha, second = levels.second.alpha;
    if (model.switching.profile == BlendProfile::over)
    {
        show(first < 1.0f ? FieldPass::blended : FieldPass::settled, levels.first.level, 0.0f, first);
        return show(FieldPass::blended, levels.second.level, 0.0f, second);
    }
    // The new level gets the pixels that the old one leaves free.
    show(second < 1.0f ? FieldPass::switching : FieldPass::settled, levels.second.level, 0.0f, second);
    show(first < 1.0f ? FieldPass::switching : FieldPass::settled, levels.first.level, second,
         first + second);
}

} // namespace osgPMObjects::core
