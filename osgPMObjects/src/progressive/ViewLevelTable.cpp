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

ViewLevelTable::Parts ViewLevelTable::find(const CullView& view, const LevelChoice& choice)
{
    const std::lock_guard lock(_mutex);
    dropUnused(view.frame);
    if (Entry* const main = borrowedEntry(view)) return partsOf(*main, main->drawn->steps, view);

    Entry& entry = entryFor(view);
    entry.frame = view.frame;
    Member* member = entry.memberOf(view.camera);
    if (!member) member = &entry.members.emplace_back(Member{view.camera, view.camera, 0, {}, {}});
    member->frame = view.frame;
    member->selection = entry.latest = choice(view, member->held);
    if (member->selection.alpha <= 0.0f) return {};
    _latest = entry.level;
    return partsOf(entry, entry.finestSteps(), view);
}

ViewLevelTable::Parts ViewLevelTable::partsOf(Entry& entry, std::uint32_t steps, const CullView& view)
{
    DrawnLevelPtr drawn = entry.level->at(steps, view.frame, view.contextId);
    if (drawn == entry.drawn) return entry.parts;
    entry.drawn = std::move(drawn);
    entry.parts.clear();
    for (std::uint32_t group = 0; group < entry.drawn->groupEnds.size(); ++group)
        if (!entry.drawn->rangesOf(group).empty())
            entry.parts.push_back(new LevelPart(entry.level, entry.drawn, group));
    return entry.parts;
}

/// The main camera's, if it sees the drawable at one place only: else nobody knows at which this one does.
ViewLevelTable::Entry* ViewLevelTable::borrowedEntry(const CullView& view)
{
    if (!view.mainCamera) return nullptr;
    Entry* found = nullptr;
    for (Entry& entry : _entries)
    {
        if (!entry.memberOf(view.mainCamera) || !entry.drawn) continue;
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
    if (!own)
    {
        own = &_entries.emplace_back();
        own->level = std::make_shared<ViewLevel>(_shape);
    }
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
        entry.level->addTo(statistics);
    }
    return all;
}

void ViewLevelTable::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (Entry& entry : _entries)
        entry.level->releaseGLObjects(state);
}

} // namespace osgPMObjects
