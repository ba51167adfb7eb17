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

/// An object whose level is to be chosen. It is plain data; the caller owns it and the tables that instances
/// share.
/// Frame: world. Units: metres.
struct SelectableObject
{
    BoundingSphere sphere;
    const LevelTable* table = nullptr;
    const SelectionSettings* settings = nullptr;
    double metresPerUnit = 1.0; ///< of the model's positions, along every axis
    Priority priority;
    OrientedBox box;                     ///< for SelectionMethod::boxArea and ellipsoidArea
    const FacingBins* facing = nullptr;  ///< for SelectionMethod::facingArea; in the frame of the box's axes
    const BenefitCurve* curve = nullptr; ///< for SelectionMethod::budget; of drawable levels only
    /// The levels that can be drawn, in steps, ascending from 0. The selector takes the coarsest of them that
    /// is no coarser than the rule asks for. Empty: all levels that SelectionSettings::leastFaces allows; a
    /// given list must obey it itself.
    std::span<const std::uint32_t> drawable;
};

/// The cause of a choice.
enum class SelectionReason : std::uint8_t
{
    rule,
    clamped,  ///< the rule asked for more steps than there are
    fullArea, ///< the volume is not wholly beyond the near plane: the finest level is chosen
    gone,     ///< the object is beyond the alpha range and is not drawn
};

/// The choice for one object.
struct Selection
{
    std::uint32_t steps = 0; ///< the level to draw; 0: the full mesh
    float alpha = 1.0f;      ///< of the alpha range
    SelectionReason reason = SelectionReason::rule;
    bool hasSwitched = false; ///< true if the level differs from the last choice; false at the first choice
};

/// Chooses the level of each object by its own method, for one view.
/// Threads: any number at once, each with its own objects. Memory: no allocation.
/// Cost: 20 to 80 ns an object; see docs/measurements/selection.md.
class LevelSelector
{
public:
    explicit LevelSelector(const SelectionView& view, const AttentionRule& attention = {})
        : _view(view), _attention(attention)
    {
    }

    /// Chooses one object's level. `held`: in and out, of this object in this view. An object with the method
    /// `budget` gets the level of the point that SceneBudget put into `held`; SceneSelector does both.
    Selection select(const SelectableObject& object, HeldLevel& held) const;

    /// Returns priorityGain() of an object: the factor by which its importance and the attention on it
    /// magnify it.
    double gainOf(const SelectableObject& object) const
    {
        return priorityGain(object.priority, _attention, _view.eyeWorld, object.sphere);
    }
    /// Returns the distance to compare with settings: from SelectionView::distancesFrom to the centre of the
    /// bounding sphere, scaled by SelectionView::distanceScale and divided by the gain. Units: metres.
    double distanceM(const SelectableObject& object, double gain) const;
    /// Returns the error, in the model's units, that its tolerance in pixels allows.
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
