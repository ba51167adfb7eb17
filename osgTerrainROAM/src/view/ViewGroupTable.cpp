// SPDX-License-Identifier: Apache-2.0
#include "ViewGroupTable.h"

#include <algorithm>
#include <shared_mutex>
#include <utility>

#include <osgTraversal/EyeSharing>

namespace osgTerrainROAM
{

ViewGroupTable::ViewGroupTable(core::PreparedPtr terrain) : _terrain(std::move(terrain))
{
    if (!_terrain) return;
    const core::HeightField& field = _terrain->tile().tile.field();
    _reachM = field.spacingEastM * field.columns + field.spacingNorthM * field.rows;
}

ViewGroupTable::Member* ViewGroupTable::Entry::memberOf(const osg::Camera* camera)
{
    const auto found =
        std::find_if(members.begin(), members.end(), [=](const Member& m) { return m.identity == camera; });
    return found == members.end() ? nullptr : &*found;
}

ViewGroupTable::Entry* ViewGroupTable::entryOf(const osg::Camera* camera)
{
    const auto found = std::find_if(_entries.begin(), _entries.end(),
                                    [=](Entry& e) { return e.memberOf(camera) != nullptr; });
    return found == _entries.end() ? nullptr : &*found;
}

ViewGroupTable::Match ViewGroupTable::find(const ViewRequest& request)
{
    const std::lock_guard lock(_mutex);
    dropUnused(request.frame);
    if (request.mainCamera)
        if (const Entry* main = entryOf(request.mainCamera)) return {main->group, request.target, true};

    Entry& entry = entryFor(request);
    entry.frame = request.frame;
    _latest = entry.group;
    leave(request.camera, &entry);
    Member* member = entry.memberOf(request.camera);
    if (!member)
    {
        entry.members.push_back({request.camera, request.camera, {}});
        member = &entry.members.back();
    }
    member->target = request.target;
    return {entry.group, strictest(entry), false};
}

ViewGroupTable::Entry& ViewGroupTable::entryFor(const ViewRequest& request)
{
    const glm::dvec3 eye = request.target.view.eyeWorld;
    const double toleranceM = osgTraversal::sameEyeToleranceM(eye, _reachM);
    const auto sharesEye = [&](const Entry& entry)
    {
        return entry.frame == request.frame && !entry.members.empty() &&
               glm::distance(entry.eye, eye) <= toleranceM &&
               entry.members.front().target.errorM == request.target.errorM;
    };
    Entry* const own = entryOf(request.camera);
    if (own && sharesEye(*own)) return *own;
    const auto shared = std::find_if(_entries.begin(), _entries.end(), sharesEye);
    if (shared != _entries.end()) return *shared;

    // The camera takes its group along, unless another camera has moved the group in this frame.
    if (own && (own->frame != request.frame || own->members.size() == 1))
    {
        own->eye = eye;
        return *own;
    }
    Entry& fresh = _entries.emplace_back();
    fresh.group = newGroup();
    fresh.eye = eye;
    return fresh;
}

/// Locks the tile while the mesh is made, because an edit may be going on.
std::shared_ptr<ViewGroup> ViewGroupTable::newGroup() const
{
    const std::shared_lock lock(_terrain->tile().mutex());
    return std::make_shared<ViewGroup>(_terrain->newMesh());
}

void ViewGroupTable::leave(const osg::Camera* camera, const Entry* except)
{
    for (Entry& entry : _entries)
        if (&entry != except)
            std::erase_if(entry.members, [=](const Member& m) { return m.identity == camera; });
}

void ViewGroupTable::dropUnused(unsigned int frame)
{
    for (Entry& entry : _entries)
        std::erase_if(entry.members, [](const Member& m) { return m.identity && !m.camera.valid(); });
    std::erase_if(_entries, [=](const Entry& entry)
                  { return osgTraversal::isUnused(entry.frame, frame) || entry.members.empty(); });
}

RefineTarget ViewGroupTable::strictest(const Entry& entry)
{
    RefineTarget target = entry.members.front().target;
    double scale = 0.0;
    bool seesAll = false;
    target.sight = {};
    for (const Member& member : entry.members)
    {
        seesAll = seesAll || member.target.sight.isEverything();
        target.sight.add(member.target.sight);
        const viewlod::ViewState& view = member.target.view;
        scale = std::max(scale, view.guaranteedPixelsPerTangent() / member.target.budget.errorTolerancePx);
        target.view.nearM = std::min(target.view.nearM, view.nearM);
    }
    if (seesAll) target.sight = {};
    target.view.eyeWorld = entry.eye;
    target.view.pixelsPerTangent = scale * target.budget.errorTolerancePx;
    target.view.cornerStretch = 1.0;
    return target;
}

std::shared_ptr<ViewGroup> ViewGroupTable::latest(double defaultErrorM)
{
    const std::lock_guard lock(_mutex);
    if (_latest) return _latest;
    _latest = newGroup();
    RefineTarget target;
    target.errorM = defaultErrorM;
    _latest->answer(0, target, viewlod::Frustum(), std::nullopt);
    return _latest;
}

std::vector<ViewGroupStatistics> ViewGroupTable::statistics() const
{
    const std::lock_guard lock(_mutex);
    std::vector<ViewGroupStatistics> all;
    for (const Entry& entry : _entries)
    {
        all.push_back(entry.group->statistics());
        all.back().cameras = static_cast<std::uint32_t>(entry.members.size());
    }
    return all;
}

void ViewGroupTable::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (Entry& entry : _entries)
        entry.group->releaseGLObjects(state);
}

} // namespace osgTerrainROAM
