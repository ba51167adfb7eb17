// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <osgPMObjects/core/selection/LevelSelector.h>
#include <osgPMObjects/core/selection/SceneBudget.h>
#include <osgPMObjects/core/selection/SelectionStatistics.h>

namespace osgPMObjects::core
{

/// What all objects of a scene may cost together.
struct SceneBudgetSettings
{
    CostModel cost{};
    std::uint64_t budget = std::numeric_limits<std::uint64_t>::max(); ///< in the unit of the cost
    double band = SceneBudget::kDefaultBand;
};

/// Chooses the levels of all objects in sight: those with a rule of their own by LevelSelector, then those with the method
/// `budget`, which share what the others leave of the budget.
/// An object's benefit is its size in the picture, π·(K·r/d)² pixels wherever it is in it, times the square of its
/// priority's gain, times the gain of its BenefitCurve; detail beyond its tolerance in pixels is worth nothing.
/// Threads: one at a time; its buffers are kept. Memory: some 90 B an object with the method `budget`.
/// Source: Funkhouser & Séquin (1993); see SceneBudget.
class SceneSelector
{
public:
    /// `held` and `selections`: by object, the first in and out, the second out. Bounds nothing when even the coarsest
    /// levels are too many: the statistics say so.
    SelectionStatistics select(const LevelSelector& selector, std::span<const SelectableObject> objects,
                               std::span<HeldLevel> held, std::span<Selection> selections,
                               const SceneBudgetSettings& settings = {});

private:
    void add(const LevelSelector& selector, const SelectableObject& object, HeldLevel held,
             std::uint32_t number);

    SceneBudget _budget;
    std::vector<BudgetedObject> _budgeted;
    std::vector<std::uint32_t> _points;  ///< by budgeted object
    std::vector<std::uint32_t> _numbers; ///< of the objects
};

} // namespace osgPMObjects::core
