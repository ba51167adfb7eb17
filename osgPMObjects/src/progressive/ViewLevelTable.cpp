// SPDX-License-Identifier: Apache-2.0
#include "ViewLevelTable.h"

#include <algorithm>
#include <limits>

namespace osgPMObjects
{

ViewLevelTable::Member* ViewLevelTable::Entry::memberOf(const osg::Camera* camera)
{
    const auto found =
        std::find_if(members.begin(), members.end(), [=](const Member& m) { return m.identity == camera; });
    return found == members.end() ? nullptr : &*found;
}

/// Of those that asked in this frame or, as they come one after the other, in the last one.
std::uint32_t ViewLevelTable::Entry::finestSteps() const
{
    std::uint32_t steps = std::numeric_limits<std::uint32_t>::max();
    for (const Member& member : members)
        if (member.frame + 1 >= frame && member.selection.alpha > 0.0f)
            steps = std::min(steps, member.selection.steps);
    return steps;
}

ShownLevels ViewLevelTable::find(const CullView& view, const LevelChoice& choice,
                                 const ProgressiveDrawable::Switching& switching)
{
    const std::lock_guard lock(_mutex);
    dropUnused(view.frame);
    if (Entry* const main = borrowedEntry(view))
        return shownOf(*main, main->memberOf(view.mainCamera)->selection.alpha, view);

    Entry& entry = entryFor(view);
    entry.frame = view.frame;
    Member* member = entry.memberOf(view.camera);
    if (!member) member = &entry.members.emplace_back(Member{view.camera, view.camera, 0, {}, {}});
    member->frame = view.frame;
    member->selection = entry.latest = choice(view, member->held);
    if (member->selection.alpha <= 0.0f) return {};
    _latest = entry.levels.level();
    entry.drawn = entry.switching.advance(entry.finestSteps(), view, switching.settings, switching.number);
    entry.byDoor = switching.settings.method == core::SwitchMethod::blend &&
                   switching.settings.profile == core::BlendProfile::cross;
    return shownOf(entry, member->selection.alpha, view);
}

ShownLevels ViewLevelTable::shownOf(Entry& entry, float alpha, const CullView& view)
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

/// The main camera's, if it sees the drawable at one place only: else nobody knows at which this one does.
ViewLevelTable::Entry* ViewLevelTable::borrowedEntry(const CullView& view)
{
    if (!view.mainCamera) return nullptr;
    Entry* found = nullptr;
    for (Entry& entry : _entries)
    {
        if (!entry.memberOf(view.mainCamera) || !entry.levels.isMade()) continue;
        if (found) return nullptr;
        found = &entry;
    }
    return found;
}

ViewLevelTable::Entry& ViewLevelTable::entryFor(const CullView& view)
{
    const glm::dvec3& eye = view.view.eyeWorld;
    const double sameEye = kSameEye * (glm::length(eye) + _shape->sphere().radius * view.metresPerUnit);
    Entry* own = nullptr;
    for (Entry& entry : _entries)
    {
        if (entry.frame == view.frame)
        {
            if (glm::distance(entry.eye, eye) <= sameEye) return entry;
        }
        else if (entry.memberOf(view.camera) &&
                 (!own || glm::distance(entry.eye, eye) < glm::distance(own->eye, eye)))
            own = &entry;
    }
    if (!own) own = &_entries.emplace_back(_shape);
    own->eye = eye;
    return *own;
}

void ViewLevelTable::dropUnused(unsigned int frame)
{
    const auto isOld = [=](unsigned int last) { return frame > last && frame - last > kUnusedFrames; };
    for (Entry& entry : _entries)
        std::erase_if(entry.members,
                      [&](const Member& m) { return isOld(m.frame) || (m.identity && !m.camera.valid()); });
    std::erase_if(_entries, [&](const Entry& entry) { return isOld(entry.frame) || entry.members.empty(); });
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
    for (const Entry& entry : _entries)
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
    for (Entry& entry : _entries)
        entry.levels.releaseGLObjects(state);
}

} // namespace osgPMObjects
