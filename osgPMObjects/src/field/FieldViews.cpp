// SPDX-License-Identifier: Apache-2.0
#include "FieldViews.h"

#include <chrono>

#include "FieldSolid.h"

namespace osgPMObjects
{

FieldViews::FieldViews(core::Field field) : _field(std::move(field))
{
    for (const core::FieldCell& cell : _field.cells())
        _bound.expandBy(roundedUp(cell.sphere));
}

core::FieldCamera FieldViews::cameraOf(const CullView& view, const ProgressiveFieldSettings& settings) const
{
    core::FieldCamera camera;
    camera.view =
        core::SelectionView::from(view.view, 1.0 / view.lodScale, settings.referencePixelsPerTangent);
    camera.eye = view.view.eyeWorld;
    camera.frustum = view.view.frustum;
    camera.attention = settings.attention;
    camera.metresPerUnit = view.metresPerUnit;
    camera.frame = view.frame;
    camera.budget = settings.budget;
    return camera;
}

/// Advances the group's time once a frame, with the first of its cameras.
void FieldViews::step(Groups::Entry& entry, const CullView& view)
{
    if (entry.steppedFrame == view.frame) return;
    entry.stepS = static_cast<float>(std::max(0.0, view.timeS - entry.timeS));
    entry.timeS = view.timeS;
    entry.steppedFrame = view.frame;
}

std::shared_ptr<const CulledField> FieldViews::look(const CullView& view,
                                                    const ProgressiveFieldSettings& settings)
{
    const std::lock_guard lock(_mutex);
    const auto begin = std::chrono::steady_clock::now();
    _groups.dropUnused(view.frame);
    core::FieldCamera camera = cameraOf(view, settings);
    Groups::Entry* entry = _groups.borrowed(view, [](const Group& group) { return group.view != nullptr; });
    const bool isBorrowed = entry != nullptr;
    const double reachM = (_bound.center().length() + _bound.radius()) * view.metresPerUnit;
    if (!isBorrowed) entry = &_groups.find(view, reachM);
    if (!entry->view)
    {
        entry->view = std::make_unique<core::FieldView>(_field);
        entry->timeS = view.timeS;
    }
    step(*entry, view);
    camera.stepS = entry->stepS;
    Groups::Member& member = _groups.memberOf(*entry, view);
    if (isBorrowed)
        camera.view = entry->chosenBy;
    else
        entry->chosenBy = camera.view;

    const auto culled = std::make_shared<CulledField>();
    const auto pixelM = view.isParallel ? std::optional(1.0 / view.view.pixelsPerTangent) : std::nullopt;
    culled->drawList = isBorrowed ? entry->view->lend(camera, pixelM) : entry->view->update(camera);
    culled->serial = ++_serial;
    if (!member.buffer) member.buffer = std::make_shared<InstanceBuffer>();
    culled->buffer = member.buffer;
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    if (!isBorrowed) note(*entry, *culled, took.count());
    return culled;
}

void FieldViews::note(Groups::Entry& entry, const CulledField& culled, double cullMs) const
{
    const core::FieldDrawList& drawList = culled.drawList;
    FieldViewStatistics& statistics = entry.statistics;
    statistics = {};
    statistics.frame = entry.frame;
    statistics.cameras = static_cast<std::uint32_t>(entry.members.size());
    statistics.selection = drawList.selection;
    statistics.visible = drawList.visible;
    statistics.drawn = drawList.drawn;
    statistics.switching = drawList.switching;
    statistics.triangles = drawList.triangles;
    statistics.cullMs = cullMs;
    statistics.bytesUploaded = drawList.instances.size() * sizeof(core::InstanceAttributes);
    for (const core::FieldBatch& batch : drawList.batches)
    {
        const std::uint32_t passes = batch.pass == core::FieldPass::blended ? 2 : 1;
        statistics.drawCalls +=
            passes * (batch.endRun - batch.firstRun) * _field.models()[batch.model].ladder->groups;
    }
}

std::vector<FieldViewStatistics> FieldViews::statistics() const
{
    const std::lock_guard lock(_mutex);
    std::vector<FieldViewStatistics> all;
    for (const Groups::Entry& entry : _groups.entries())
        all.push_back(entry.statistics);
    return all;
}

void FieldViews::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (Groups::Entry& entry : _groups.entries())
        for (Groups::Member& member : entry.members)
            if (member.buffer) member.buffer->releaseGLObjects(state);
}

} // namespace osgPMObjects
