// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/core/selection/LevelSelector.h>
#include <osgPMObjects/core/selection/SceneBudget.h>
#include <osgPMObjects/core/selection/SelectionStatistics.h>

namespace osgPMObjects::core
{

/// The limit on the cost of all objects of a scene. Invariant: checkSettings().
struct SceneBudgetSettings
{
    CostModel cost{};
    std::uint64_t budget =
        std::numeric_limits<std::uint64_t>::max(); ///< in the unit of the cost; default: no limit
    double band = SceneBudget::kDefaultBand; ///< hysteresis: factor of benefit / cost; at least 1, finite
};

/// Tells whether levels can be chosen by these settings: else an error that names the field. SceneSelector
/// does not check.
foundation::Outcome checkSettings(const SceneBudgetSettings& settings);

/// Chooses one object's level as if nothing had been chosen before and the budget had no limit.
Selection selectAlone(const LevelSelector& selector, const SelectableObject& object);

/// Chooses the levels of all visible objects. Objects with a rule of their own get theirs from LevelSelector;
/// then the objects with the method `budget` share the rest of the budget. An object's benefit is the gain of
/// its BenefitCurve times its projected size, π·(K·r/d)² pixels wherever it is in the image, times the square
/// of priorityGain(). Detail beyond its tolerance in pixels has no benefit.
/// Threads: one at a time; buffers are kept. Memory: some 90 B an object with the method `budget`.
/// Source: Funkhouser & Séquin (1993); see SceneBudget.
class SceneSelector
{
public:
    /// Chooses all levels. `held` (in and out) and `selections` (out): by object. If even the coarsest levels
    /// exceed the budget they are chosen, and BudgetResult::fits of the returned statistics is false.
    SelectionStatistics select(const LevelSelector& selector, std::span<const SelectableObject> objects,
                               std::span<HeldLevel> held, std::span<Selection> selections,
                               const SceneBudgetSettings& settings = {});

private:
    void add(const LevelSelector& selector, const SelectableObject& object, HeldLevel held,
             std::uint32_t number);

    SceneBudget _budget;
    std::vector<BudgetedObject> _budgeted;
    std::vector<std::uint32_t> _points;  ///< by budgeted object
    std::vector<std::uint32_t> _numbers; ///< by budgeted object: its index in `objects`
};

} // namespace osgPMObjects::core
