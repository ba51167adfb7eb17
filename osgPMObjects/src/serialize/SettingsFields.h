// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/ProgressiveField>
#include <osgPMObjects/ProgressiveNode>

#include "SettingsNames.h"

namespace osgPMObjects::core
{

/// The two distances of a boundary between ranges, as values of a line.
template<class Visit>
void visitNumbers(auto& boundary, Visit&& visit) requires requires
{
    boundary.nearM;
}
{
    visit(boundary.nearM);
    visit(boundary.farM);
}

} // namespace osgPMObjects::core

namespace osgPMObjects
{

/// These call visit(name, field) once for every field of settings, both to write them and to read them
/// (osgTraversal/ValueLines).
template<class Settings, class Visit>
void visitSelection(Settings& selection, Visit& visit)
{
    visit("method", selection.method);
    visit("ranges.boundariesM", selection.ranges.boundariesM);
    visit("ranges.steps", selection.ranges.steps);
    visit("overlappingRanges.boundaries", selection.overlappingRanges.boundaries);
    visit("overlappingRanges.steps", selection.overlappingRanges.steps);
    visit("areaRows.leastPx", selection.areaRows.leastPx);
    visit("areaRows.steps", selection.areaRows.steps);
    visit("referenceM", selection.referenceM);
    visit("trianglePx", selection.trianglePx);
    visit("tolerancePx", selection.tolerancePx);
    visit("leastFaces", selection.leastFaces);
    visit("errorKind", selection.errorKind);
    visit("weights.normal", selection.weights.normal);
    visit("weights.texCoord", selection.weights.texCoord);
    visit("weights.colour", selection.weights.colour);
    visit("band", selection.band);
    visit("continuousBand", selection.continuousBand);
    visit("alpha.fadeM", selection.alpha.fadeM);
    visit("alpha.goneM", selection.alpha.goneM);
}

template<class Settings, class Visit>
void visitSwitching(Settings& switching, Visit& visit)
{
    visit("switching.method", switching.method);
    visit("switching.profile", switching.profile);
    visit("switching.durationS", switching.durationS);
    visit("switching.staggerS", switching.staggerS);
}

/// `Settings` is ProgressiveNodeSettings, const or not.
template<class Settings, class Visit>
requires requires(Settings& settings)
{
    settings.number;
}
void visitFields(Settings& settings, Visit& visit)
{
    visitSelection(settings.selection, visit);
    visitSwitching(settings.switching, visit);
    visit("number", settings.number);
    visit("priority.importance", settings.priority.importance);
    visit("priority.isAttended", settings.priority.isAttended);
    visit("referencePixelsPerTangent", settings.referencePixelsPerTangent);
}

/// `Kind` is FieldKind, const or not; its shape is no field.
template<class Kind, class Visit>
requires requires(Kind& kind)
{
    kind.shape;
}
void visitFields(Kind& kind, Visit& visit)
{
    visitSelection(kind.selection, visit);
    visitSwitching(kind.switching, visit);
}

/// `Settings` is ProgressiveFieldSettings, const or not.
template<class Settings, class Visit>
requires requires(Settings& settings)
{
    settings.attention;
}
void visitFields(Settings& settings, Visit& visit)
{
    auto& [cost, budget, band] = settings.budget;
    visit("budget.cost.perTriangle", cost.perTriangle);
    visit("budget.cost.perVertex", cost.perVertex);
    visit("budget.cost.perDraw", cost.perDraw);
    visit("budget.budget", budget);
    visit("budget.band", band);
    visit("attention.attendedGain", settings.attention.attendedGain);
    visit("attention.peripheralGain", settings.attention.peripheralGain);
    visit("attention.gazeInnerDeg", settings.attention.gazeInnerDeg);
    visit("attention.gazeOuterDeg", settings.attention.gazeOuterDeg);
    visit("attention.gaze", settings.attention.gaze);
    visit("referencePixelsPerTangent", settings.referencePixelsPerTangent);
}

/// One instance of a field as one value: position, attitude (x, y, z, w), scale, kind, importance, whether it
/// is attended.
template<class Instance, class Visit>
void visitNumbers(Instance& instance, Visit&& visit)
{
    for (int axis = 0; axis < 3; ++axis)
        visit(instance.position[axis]);
    for (int part = 0; part < 4; ++part)
        visit(instance.attitude[part]);
    visit(instance.scale);
    visit(instance.kind);
    visit(instance.priority.importance);
    visit(instance.priority.isAttended);
}

} // namespace osgPMObjects
