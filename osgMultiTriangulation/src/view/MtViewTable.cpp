// SPDX-License-Identifier: Apache-2.0
#include "MtViewTable.h"

#include <chrono>

namespace osgMultiTriangulation
{

MtViewTable::~MtViewTable()
{
    for (const auto& group : _groups.all())
        _follower->removeView(group->detail.view);
}

core::FollowTarget MtViewTable::targetOf(const Groups::Group& group)
{
    const osgTraversal::AllowedError allowed = group.strictest();
    return {group.eye, allowed.perDistance, allowed.nearest};
}

MtAnswer MtViewTable::answer(const MtRequest& request, bool waits)
{
    const auto began = std::chrono::steady_clock::now();
    const std::lock_guard lock(_mutex);
    _groups.dropUnused(request.frame, [this](const Detail& detail) { _follower->removeView(detail.view); });
    if (request.mainCamera)
        if (const auto* main = _groups.groupOf(request.mainCamera); main && main->detail.surface)
            return {main->detail.surface, main->detail.buffers};
    Groups::Group& group =
        _groups.groupFor(request.camera, request.frame, request.eye,
                         [this] {
                             return Detail{_follower->addView(), nullptr, std::make_shared<MtBuffers>()};
                         });
    Detail& detail = group.detail;
    const bool isFirst = group.frame != request.frame || !detail.surface || group.hasMoved;
    group.hasMoved = false;
    const core::FollowTarget before = isFirst ? core::FollowTarget() : targetOf(group);
    _groups.join(group, request.camera, request.frame, request.allowed);
    const core::FollowTarget target = targetOf(group);
    if (isFirst || (waits && target != before))
    {
        auto newest = waits ? _follower->settle(detail.view, target) : _follower->follow(detail.view, target);
        if (newest) detail.surface = std::move(newest);
        if (!detail.surface) detail.surface = _follower->coarsest();
    }
    detail.stallUs =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - began).count();
    _latest = detail.surface;
    return {detail.surface, detail.buffers};
}

std::shared_ptr<const core::DrawnSurface> MtViewTable::latest() const
{
    const std::lock_guard lock(_mutex);
    return _latest;
}

std::vector<MtViewStatistics> MtViewTable::statistics() const
{
    const std::lock_guard lock(_mutex);
    std::vector<MtViewStatistics> all;
    for (const auto& group : _groups.all())
    {
        const auto& surface = group->detail.surface;
        all.push_back({group->frame, static_cast<std::uint32_t>(group->members.size()),
                       surface ? static_cast<std::uint32_t>(surface->triangles.size()) : 0,
                       group->detail.stallUs});
    }
    return all;
}

void MtViewTable::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (const auto& group : _groups.all())
        group->detail.buffers->releaseGLObjects(state);
}

} // namespace osgMultiTriangulation
