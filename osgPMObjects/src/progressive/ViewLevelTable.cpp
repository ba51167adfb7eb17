// SPDX-License-Identifier: Apache-2.0
#include "ViewLevelTable.h"

#include <algorithm>
#include <limits>

namespace osgPMObjects
{

/// Returns the finest level of the cameras that asked in this frame or, as they ask one after the other, in
/// the last one.
std::uint32_t ViewLevelTable::finestSteps(const Groups::Entry& entry)
{
    std::uint32_t steps = std::numeric_limits<std::uint32_t>::max();
    for (const Groups::Member& member : entry.members)
        if (member.frame + 1 >= entry.frame && member.selection.alpha > 0.0f)
            steps = std::min(steps, member.selection.steps);
    return steps;
}

ShownLevels ViewLevelTable::find(const CullView& view, const LevelChoice& choice,
                                 const ProgressiveDrawable::Switching& switching)
{
    const std::lock_guard lock(_mutex);
    _groups.dropUnused(view.frame);
    if (Groups::Entry* const main =
            _groups.borrowed(view, [](const Group& group) { return group.levels.isMade(); }))
        return shownOf(*main, main->memberOf(view.mainCamera)->selection.alpha, view);

    Groups::Entry& entry = _groups.find(view, _shape->sphere().radius * view.metresPerUnit, _shape);
    Groups::Member* const member = entry.memberOf(view.camera);
    member->selection = entry.latest = choice(view, member->held);
    if (member->selection.alpha <= 0.0f) return {};
    _latest = entry.levels.level();
    entry.drawn = entry.switching.advance(finestSteps(entry), view, switching.settings, switching.number);
    entry.byDoor = switching.settings.method == core::SwitchMethod::blend &&
                   switching.settings.profile == core::BlendProfile::cross;
    return shownOf(entry, member->selection.alpha, view);
}

ShownLevels ViewLevelTable::shownOf(Groups::Entry& entry, float alpha, const CullView& view)
{
    ShownLevels shown;
    if (alpha <= 0.0f) return shown;
    entry.levels.make(entry.drawn, view.frame, view.contextId);
    shown.drawn = entry.drawn;
    shown.first = entry.levels.partsOf(shown.drawn.first.level);
    if (shown.isBlend()) shown.second = entry.levels.partsOf(shown.drawn.second.level);
    shown.alpha = alpha;
    shown.finerShare = entry.switching.finerShare();
    shown.byDoor = entry.byDoor;
    if (const MorphArrays* const morph = entry.levels.morph())
    {
        shown.isMorphing = true;
        shown.firstMorphing = morph->firstVertex();
    }
    return shown;
}

std::shared_ptr<ViewLevel> ViewLevelTable::latest(std::uint32_t steps)
{
    const std::lock_guard lock(_mutex);
    if (_latest) return _latest;
    _latest = std::make_shared<ViewLevel>(_shape);
    _latest->at(steps, 0, std::nullopt);
    return _latest;
}

std::vector<ProgressiveViewStatistics> ViewLevelTable::statistics() const
{
    const std::lock_guard lock(_mutex);
    std::vector<ProgressiveViewStatistics> all;
    for (const Groups::Entry& entry : _groups.entries())
    {
        ProgressiveViewStatistics& statistics = all.emplace_back();
        statistics.frame = entry.frame;
        statistics.cameras = static_cast<std::uint32_t>(entry.members.size());
        statistics.selection = entry.latest;
        statistics.method = entry.switching.method();
        statistics.switching = entry.switching.state();
        if (const StillLevel* const other = entry.levels.still())
            statistics.secondTriangles = other->triangles();
        entry.levels.level()->addTo(statistics);
    }
    return all;
}

void ViewLevelTable::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (Groups::Entry& entry : _groups.entries())
        entry.levels.releaseGLObjects(state);
}

} // namespace osgPMObjects
