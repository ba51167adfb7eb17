// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/BoxArea.h>
#include <osgPMObjects/core/selection/ContinuousRule.h>
#include <osgPMObjects/core/selection/DrawableRows.h>
#include <osgPMObjects/core/selection/EllipsoidArea.h>
#include <osgPMObjects/core/selection/LevelSelector.h>
#include <osgPMObjects/core/selection/SphereArea.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns the levels among which a measured error decides; estimates never fall, so a finer level than
/// theirs is good, too.
AllowedLevels allowedOf(const SelectableObject& object)
{
    if (object.table->measured.isEmpty()) return {};
    if (!object.drawable.empty()) return {.drawable = object.drawable};
    const std::uint32_t least = object.settings->leastFaces;
    return {.mostSteps = least > 0 ? object.table->coarsestWith(least) : object.table->mostSteps()};
}

} // namespace

double LevelSelector::distanceM(const SelectableObject& object, double gain) const
{
    return glm::length(object.sphere.centre - _view.distancesFrom) * _view.distanceScale / gain;
}

double LevelSelector::toleranceOf(const SelectableObject& object, double gain) const
{
    const double depth = glm::length(object.sphere.centre - _view.eyeWorld) - object.sphere.radius;
    return tolerableError(object.settings->tolerancePx, _view.guaranteedPixelsPerTangent * gain,
                          std::max(depth, _view.nearM), object.metresPerUnit);
}

double LevelSelector::areaPx(const SelectableObject& object) const
{
    switch (object.settings->method)
    {
    case SelectionMethod::boxArea:
        return boxAreaPx(_view, object.box);
    case SelectionMethod::ellipsoidArea:
        return ellipsoidAreaPx(_view, Ellipsoid::within(object.box));
    case SelectionMethod::facingArea:
        return facingAreaPx(_view, object.sphere, *object.facing, object.box.axes, object.metresPerUnit);
    default:
        return sphereAreaPx(_view, object.sphere);
    }
}

Selection LevelSelector::byArea(const SelectableObject& object, double gain, HeldLevel& held) const
{
    const SelectionSettings& settings = *object.settings;
    const double area = areaPx(object);
    held.level = areaRowAt(settings.areaRows, area * gain * gain, settings.band, held);
    Selection selection{settings.areaRows.steps[held.level]};
    if (area == kFullArea) selection.reason = SelectionReason::fullArea;
    return selection;
}

Selection LevelSelector::byRemoval(const SelectableObject& object, double gain, double distanceM,
                                   HeldLevel& held) const
{
    const SelectionSettings& settings = *object.settings;
    const LevelTable& table = *object.table;
    const bool isGiven = settings.referenceM > 0.0;
    // The default reference is that of this view's pixels, so distances are taken from its eye.
    const double reference =
        isGiven ? settings.referenceM
                : object.metresPerUnit * referenceDistanceM(_view.pixelsPerTangent, table.area,
                                                            table.faces.front(), settings.trianglePx);
    const double distance = isGiven ? distanceM : glm::length(object.sphere.centre - _view.eyeWorld) / gain;
    const Removal removal =
        heldRemovalAt(reference, distance, table.positions, table.mostSteps(), settings.continuousBand, held);
    held.level = removal.steps;
    return {removal.steps, 1.0f, removal.isClamped ? SelectionReason::clamped : SelectionReason::rule};
}

Selection LevelSelector::byMethod(const SelectableObject& object, double gain, double distanceM,
                                  HeldLevel& held) const
{
    const SelectionSettings& settings = *object.settings;
    switch (settings.method)
    {
    case SelectionMethod::ranges:
        held.level = rangeAt(settings.ranges.boundariesM, distanceM);
        return {settings.ranges.steps[held.level]};
    case SelectionMethod::overlappingRanges:
        held.level = overlappingRangeAt(settings.overlappingRanges, distanceM, held);
        return {settings.overlappingRanges.steps[held.level]};
    case SelectionMethod::continuous:
        return byRemoval(object, gain, distanceM, held);
    case SelectionMethod::screenError:
        held.level = heldWithin(*object.table, toleranceOf(object, gain), settings.band, held,
                                settings.measure(), allowedOf(object));
        return {held.level, 1.0f,
                held.level == object.table->mostSteps() ? SelectionReason::clamped : SelectionReason::rule};
    case SelectionMethod::budget:
        held.level = held.isHeld() ? std::min(held.level, object.curve->last()) : 0;
        return {object.curve->points[held.level].steps};
    default:
        return byArea(object, gain, held);
    }
}

Selection LevelSelector::select(const SelectableObject& object, HeldLevel& held) const
{
    const double gain = gainOf(object);
    const double distance = distanceM(object, gain);
    const float alpha = object.settings->alpha.alphaAt(distance);
    if (alpha <= 0.0f)
    {
        held = {};
        return {object.table->mostSteps(), 0.0f, SelectionReason::gone};
    }
    const HeldLevel before = held;
    Selection selection = byMethod(object, gain, distance, held);
    if (!object.drawable.empty())
        selection.steps = object.drawable[drawableRowOf(object.drawable, selection.steps)];
    else if (const std::uint32_t least = object.settings->leastFaces; least > 0)
        selection.steps = std::min(selection.steps, object.table->coarsestWith(least));
    selection.alpha = alpha;
    selection.hasSwitched = before.isHeld() && before.level != held.level;
    return selection;
}

} // namespace osgPMObjects::core
