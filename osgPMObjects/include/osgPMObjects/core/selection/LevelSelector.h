// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <osgPMObjects/core/selection/BenefitCurve.h>
#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/FacingArea.h>
#include <osgPMObjects/core/selection/HeldLevel.h>
#include <osgPMObjects/core/selection/LevelTable.h>
#include <osgPMObjects/core/selection/Priority.h>
#include <osgPMObjects/core/selection/SelectionSettings.h>
#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

/// An object that a level is chosen for: plain data, owned by the caller, as are the tables that instances share.
/// Frame: world. Units: metres.
struct SelectableObject
{
    BoundingSphere sphere;
    const LevelTable* table = nullptr;
    const SelectionSettings* settings = nullptr;
    double metresPerUnit = 1.0; ///< of the model's positions; the same along all axes
    Priority priority;
    OrientedBox box;                     ///< for the areas of boxes and ellipsoids
    const FacingBins* facing = nullptr;  ///< for the facing area, about the box's axes
    const BenefitCurve* curve = nullptr; ///< for the budget; of levels that can be drawn
    /// The levels that can be drawn, in steps, ascending from 0: of those the coarsest is taken that is no coarser than what
    /// the rule asks for. Empty: all that SelectionSettings::leastFaces allows; who gives levels leaves those out himself.
    std::span<const std::uint32_t> drawn;
};

/// What a level was chosen by besides the rule itself.
enum class SelectionReason : std::uint8_t
{
    rule,
    clamped,  ///< the rule asked for more steps than there are
    fullArea, ///< the volume is not wholly beyond the near plane: the finest level
    gone,     ///< beyond the alpha range: not to be processed
};

/// What to draw of an object.
struct Selection
{
    std::uint32_t steps = 0; ///< of the CollapseSequence; 0: the full mesh; a level that can be drawn
    float alpha = 1.0f;      ///< of the alpha range
    SelectionReason reason = SelectionReason::rule;
    bool hasSwitched = false; ///< the rule asks for another level than last time; not the first time
};

/// The one front of all rules: chooses each object's level by its own method, for one view.
/// Threads: any number at once, each with its own objects. Memory: none of its own; nothing is allocated.
/// Cost: see docs/measurements/selection.md; 20 to 80 ns an object.
class LevelSelector
{
public:
    explicit LevelSelector(const SelectionView& view, const AttentionRule& attention = {})
        : _view(view), _attention(attention)
    {
    }

    /// `held`: in and out, the object's own in this view. An object with the method `budget` is given the level of the
    /// point that SceneBudget has put there; SceneSelector does both.
    Selection select(const SelectableObject& object, HeldLevel& held) const;

    /// What an object's importance and the attention it has are worth.
    double gainOf(const SelectableObject& object) const
    {
        return priorityGain(object.priority, _attention, _view.eyeWorld, object.sphere);
    }
    /// Distance from the centre of the bounding sphere, as the author's camera would have it (SelectionView::distancesFrom). Units: metres.
    double distanceM(const SelectableObject& object, double gain) const;
    /// The error in the model's units that its tolerance in pixels allows.
    double toleranceOf(const SelectableObject& object, double gain) const;

    const SelectionView& view() const { return _view; }

private:
    Selection byArea(const SelectableObject& object, double gain, HeldLevel& held) const;
    double areaPx(const SelectableObject& object) const;
    Selection byRemoval(const SelectableObject& object, double gain, double distanceM, HeldLevel& held) const;
    Selection byMethod(const SelectableObject& object, double gain, double distanceM, HeldLevel& held) const;

    SelectionView _view;
    AttentionRule _attention;
};

} // namespace osgPMObjects::core
