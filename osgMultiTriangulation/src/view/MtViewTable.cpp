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

MtAnswer MtViewTable::answer(const osgTraversal::EyeRequest& request, bool waits)
{
    const auto began = std::chrono::steady_clock::now();
    const std::lock_guard lock(_mutex);
    const auto asked = _groups.ask(
        request,
        [this] {
            return Detail{_follower->addView(), nullptr, std::make_shared<MtBuffers>()};
        },
        [this](const Detail& left) { _follower->removeView(left.view); },
        [](const Detail& given) { return given.surface != nullptr; });
    Detail& detail = asked.group.detail;
    if (asked.isOfMain) return {detail.surface, detail.buffers};
    if (asked.isFirst || (waits && asked.isChanged))
    {
        const core::FollowTarget target = targetOf(asked.group);
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
