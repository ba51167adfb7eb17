// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>

#include <glm/glm.hpp>

#include <osgPMObjects/core/field/FieldView.h>

#include "FieldSorter.h"
#include "FieldSwitch.h"

namespace osgPMObjects::core
{

namespace
{

/// Returns the number of faces that show the outline of an object of this radius in pixels: one for four
/// pixels of its disc.
std::uint32_t facesFor(double radiusPx)
{
    return static_cast<std::uint32_t>(std::min(0.25 * std::numbers::pi * radiusPx * radiusPx, 1e9));
}

} // namespace

FieldView::FieldView(const Field& field) : _field(field), _memory(field.objects().size()) {}

void FieldView::findVisible(const FieldCamera& camera)
{
    const viewlod::Frustum& frustum = camera.frustum;
    const double metresPerUnit = camera.metresPerUnit;
    constexpr viewlod::Frustum::Mask kSides = 0x0F; // left, right, bottom, top
    _visible.clear();
    for (const FieldCell& cell : _field.cells())
    {
        const double nearestM = glm::distance(cell.sphere.centre * metresPerUnit, camera.view.distancesFrom) -
                                cell.sphere.radius * metresPerUnit;
        if (nearestM * camera.view.distanceScale >= cell.goneM * camera.attention.attendedGain) continue;
        const auto verdict =
            frustum.classify(cell.sphere.centre * metresPerUnit, cell.sphere.radius * metresPerUnit, kSides);
        if (verdict.outside) continue;
        for (std::uint32_t i = cell.first; i < cell.end; ++i)
        {
            const BoundingSphere& sphere = _field.spheres()[i];
            if (verdict.crossing == 0 ||
                !frustum
                     .classify(sphere.centre * metresPerUnit, sphere.radius * metresPerUnit, verdict.crossing)
                     .outside)
                _visible.push_back(i);
        }
    }
}

const BenefitCurve* FieldView::curveOf(std::uint32_t model, const CostModel& cost)
{
    const FieldModel& asked = _field.models()[model];
    if (asked.selection.method != SelectionMethod::budget) return nullptr;
    if (!_curvesCost || !(*_curvesCost == cost))
    {
        _curvesCost = cost;
        _curves.clear();
        for (std::uint32_t i = 0; i < _field.models().size(); ++i)
        {
            const FieldModel& each = _field.models()[i];
            _curves.push_back(BenefitCurve::ofLevels(*each.table, _field.allowedRungs(i),
                                                     std::max(each.sphere.radius, 1e-9), cost,
                                                     each.selection.measure()));
        }
    }
    return &_curves[model];
}

void FieldView::choose(const FieldCamera& camera, FieldDrawList& drawList)
{
    _selectable.clear();
    _held.clear();
    for (const std::uint32_t i : _visible)
    {
        SelectableObject& object = _selectable.emplace_back(_field.selectable(i, camera.metresPerUnit));
        object.curve = curveOf(_field.objects()[i].model, camera.budget.cost);
        const Memory& memory = _memory[i];
        const bool isRemembered = memory.frame == camera.frame || memory.frame + 1 == camera.frame;
        _held.push_back(isRemembered ? memory.held : HeldLevel{});
    }
    _selections.resize(_visible.size());
    drawList.selection = _selector.select(LevelSelector(camera.view, camera.attention), _selectable, _held,
                                          _selections, camera.budget);
}

void FieldView::followEye(const FieldCamera& camera)
{
    if (camera.frame == _eyeFrame) return;
    _movedM = _eyeFrame + 1 == camera.frame ? glm::distance(camera.view.distancesFrom, _eye) : 0.0;
    _eye = camera.view.distancesFrom;
    _eyeFrame = camera.frame;
}

bool FieldView::hasJumpedTo(std::uint32_t object, const FieldCamera& camera) const
{
    constexpr double kShare = 0.5; // of the distance
    const glm::dvec3 centre = _field.spheres()[object].centre * camera.metresPerUnit;
    return _movedM > kShare * glm::distance(centre, camera.view.distancesFrom);
}

DrawnLevels FieldView::advance(std::uint32_t object, const Selection& selection, const FieldCamera& camera)
{
    const FieldModel& model = _field.models()[_field.objects()[object].model];
    Memory& memory = _memory[object];
    const std::uint32_t wanted = model.ladder->rungOf(selection.steps);
    const bool wasSeen = memory.frame == camera.frame || memory.frame + 1 == camera.frame;
    if (!wasSeen || (memory.frame != camera.frame && hasJumpedTo(object, camera)))
        memory.state = SwitchState::at(wanted);
    const float stepS = memory.frame == camera.frame ? 0.0f : camera.stepS;
    memory.frame = camera.frame;
    memory.drawn = advanceOnLadder(memory.state, wanted, stepS, selection.alpha, _field.numberOf(object),
                                   model.switching);
    return memory.drawn;
}

DrawnLevels FieldView::lent(std::uint32_t object, const FieldCamera& camera, std::optional<double> pixelM)
{
    const std::uint32_t number = _field.objects()[object].model;
    const FieldModel& model = _field.models()[number];
    const Memory& memory = _memory[object];
    const bool isChosen = memory.frame == camera.frame;
    SelectableObject selectable = _field.selectable(object, camera.metresPerUnit);
    selectable.curve = curveOf(number, camera.budget.cost);
    std::uint32_t steps = 0;
    if (pixelM)
        steps = model.table->coarsestWith(
            std::max(facesFor(selectable.sphere.radius / *pixelM), model.selection.leastFaces));
    else if (!isChosen)
        steps = selectAlone(LevelSelector(camera.view, camera.attention), selectable).steps;
    const std::uint32_t rung = model.ladder->rungOf(steps);
    if (isChosen && (!pixelM || rung <= memory.state.from || !memory.drawn.isDrawn())) return memory.drawn;
    SwitchState still = SwitchState::at(rung);
    return advanceOnLadder(still, rung, 0.0f, 1.0f, _field.numberOf(object), model.switching);
}

FieldDrawList FieldView::lend(const FieldCamera& camera, std::optional<double> pixelM)
{
    FieldDrawList drawList;
    findVisible(camera);
    FieldSorter sorter(_field);
    const glm::dvec3 eye = camera.eye / camera.metresPerUnit;
    for (const std::uint32_t object : _visible)
    {
        if (pixelM && _field.spheres()[object].radius * camera.metresPerUnit < *pixelM) continue;
        const DrawnLevels levels = lent(object, camera, pixelM);
        ++drawList.visible;
        drawList.drawn += levels.isDrawn() ? 1 : 0;
        showLevels(sorter, _field, object, levels, eye);
    }
    sorter.fill(drawList);
    return drawList;
}

FieldDrawList FieldView::update(const FieldCamera& camera)
{
    FieldDrawList drawList;
    followEye(camera);
    findVisible(camera);
    choose(camera, drawList);
    FieldSorter sorter(_field);
    const glm::dvec3 eye = camera.eye / camera.metresPerUnit;
    drawList.visible = static_cast<std::uint32_t>(_visible.size());
    for (std::size_t i = 0; i < _visible.size(); ++i)
    {
        const std::uint32_t object = _visible[i];
        const DrawnLevels levels = advance(object, _selections[i], camera);
        _memory[object].held = _held[i];
        drawList.drawn += levels.isDrawn() ? 1 : 0;
        drawList.switching += _memory[object].state.isSwitching() ? 1 : 0;
        showLevels(sorter, _field, object, levels, eye);
    }
    sorter.fill(drawList);
    return drawList;
}

} // namespace osgPMObjects::core
