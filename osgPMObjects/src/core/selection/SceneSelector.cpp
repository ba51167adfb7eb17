// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <numbers>

#include <foundation/SettingsCheck.h>
#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/SceneSelector.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns the last useful point of a curve: the cheapest one within a tolerance (the model's units), with
/// the hysteresis of heldWithin(). Unlike levels, points go from coarse to fine.
std::uint32_t finestOfUse(const BenefitCurve& curve, double tolerance, double band, HeldLevel held)
{
    const auto& points = curve.points;
    if (held.level <= curve.last())
    {
        const bool isWithin = held.level == curve.last() || points[held.level].error <= tolerance;
        const bool isNeeded = held.level == 0 || points[held.level - 1].error > tolerance / (band * band);
        if (isWithin && isNeeded) return held.level;
    }
    const auto point = std::partition_point(
        points.begin(), points.end(), [&](const BenefitPoint& p) { return p.error > tolerance / band; });
    return std::min(static_cast<std::uint32_t>(point - points.begin()), curve.last());
}

double sizePx(const SelectionView& view, const BoundingSphere& sphere)
{
    const double distance = std::max(glm::length(sphere.centre - view.eyeWorld), sphere.radius + view.nearM);
    const double radius = sphere.radius / distance;
    return std::numbers::pi * view.pixelsPerTangentArea * radius * radius;
}

} // namespace

foundation::Outcome checkSettings(const SceneBudgetSettings& settings)
{
    return foundation::SettingsCheck("budget")
        .within("cost.perTriangle", settings.cost.perTriangle, 0.0, CostModel::kMostEach)
        .within("cost.perVertex", settings.cost.perVertex, 0.0, CostModel::kMostEach)
        .within("cost.perDraw", settings.cost.perDraw, 0.0, CostModel::kMostEach)
        .within("band", settings.band, 1.0)
        .outcome();
}

Selection selectAlone(const LevelSelector& selector, const SelectableObject& object)
{
    HeldLevel held;
    if (object.settings->method == SelectionMethod::budget)
        held.level = finestOfUse(*object.curve, selector.toleranceOf(object, selector.gainOf(object)),
                                 object.settings->band, {});
    return selector.select(object, held);
}

void SceneSelector::add(const LevelSelector& selector, const SelectableObject& object, HeldLevel held,
                        std::uint32_t number)
{
    const double gain = selector.gainOf(object);
    _budgeted.push_back(
        {object.curve, sizePx(selector.view(), object.sphere) * gain * gain,
         finestOfUse(*object.curve, selector.toleranceOf(object, gain), object.settings->band, held)});
    _points.push_back(held.isHeld() ? held.level : 0);
    _numbers.push_back(number);
}

SelectionStatistics SceneSelector::select(const LevelSelector& selector,
                                          std::span<const SelectableObject> objects,
                                          std::span<HeldLevel> held, std::span<Selection> selections,
                                          const SceneBudgetSettings& settings)
{
    assert(held.size() == objects.size() && selections.size() == objects.size());
    SelectionStatistics statistics;
    _budgeted.clear();
    _points.clear();
    _numbers.clear();
    std::uint64_t spent = 0; // by objects with a rule of their own
    for (std::uint32_t i = 0; i < objects.size(); ++i)
    {
        const SelectableObject& object = objects[i];
        const HeldLevel before = held[i];
        selections[i] = selector.select(object, held[i]);
        const bool isGone = selections[i].reason == SelectionReason::gone;
        if (object.settings->method == SelectionMethod::budget && !isGone)
        {
            add(selector, object, before, i);
            held[i] = before;
            continue;
        }
        const LevelTable& table = *object.table;
        const std::uint32_t steps = selections[i].steps, triangles = table.faces[steps];
        statistics.of(object.settings->method).count(selections[i], triangles);
        if (!isGone)
            spent += settings.cost.of(triangles, table.positions > steps ? table.positions - steps : 0);
    }

    statistics.budget =
        _budget.choose(_budgeted, _points, settings.budget - std::min(settings.budget, spent), settings.band);
    statistics.budget.fits &= spent <= settings.budget;
    for (std::size_t i = 0; i < _numbers.size(); ++i)
    {
        HeldLevel& level = held[_numbers[i]];
        Selection& selection = selections[_numbers[i]];
        const SelectableObject& object = objects[_numbers[i]];
        selection.hasSwitched = level.isHeld() && level.level != _points[i];
        level.level = _points[i];
        selection.steps = object.curve->points[_points[i]].steps;
        statistics.of(SelectionMethod::budget).count(selection, object.table->faces[selection.steps]);
    }
    return statistics;
}

} // namespace osgPMObjects::core
