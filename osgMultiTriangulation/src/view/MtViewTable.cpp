// SPDX-License-Identifier: Apache-2.0
#include "MtViewTable.h"

#include <algorithm>
#include <chrono>

#include <osgTraversal/EyeSharing>

namespace osgMultiTriangulation
{

MtViewTable::~MtViewTable()
{
    for (const auto& group : _groups)
        _follower->removeView(group->view);
}

bool MtViewTable::Group::has(const osg::Camera* camera) const
{
    return std::ranges::any_of(members, [=](const Member& m) { return m.identity == camera; });
}

MtViewTable::Group* MtViewTable::groupOf(const osg::Camera* camera)
{
    const auto found = std::ranges::find_if(_groups, [=](const auto& group) { return group->has(camera); });
    return found == _groups.end() ? nullptr : found->get();
}

MtAnswer MtViewTable::answer(const MtRequest& request, bool waits)
{
    const auto began = std::chrono::steady_clock::now();
    const std::lock_guard lock(_mutex);
    dropUnused(request.frame);
    if (request.mainCamera)
        if (const Group* main = groupOf(request.mainCamera); main && main->surface)
            return {main->surface, main->buffers};
    Group& group = groupFor(request);
    const bool isFirst = group.frame != request.frame || !group.surface || group.hasMoved;
    group.hasMoved = false;
    const core::FollowTarget before = isFirst ? core::FollowTarget() : strictest(group);
    for (const auto& other : _groups)
        std::erase_if(other->members, [&](const Member& m) { return m.identity == request.camera; });
    group.members.push_back({request.camera, request.camera, request.target});
    group.frame = request.frame;
    const core::FollowTarget target = strictest(group);
    if (isFirst || (waits && target != before))
    {
        auto newest = waits ? _follower->settle(group.view, target) : _follower->follow(group.view, target);
        if (newest) group.surface = std::move(newest);
        if (!group.surface) group.surface = _follower->coarsest();
    }
    group.stallUs =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - began).count();
    _latest = group.surface;
    return {group.surface, group.buffers};
}

MtViewTable::Group& MtViewTable::groupFor(const MtRequest& request)
{
    const glm::dvec3 eye = request.target.eye;
    const double toleranceM = osgTraversal::sameEyeToleranceM(eye, _reachM);
    const auto sharesEye = [&](const Group& group)
    { return group.frame == request.frame && glm::distance(group.eye, eye) <= toleranceM; };
    Group* const own = groupOf(request.camera);
    if (own && sharesEye(*own)) return *own;
    for (const auto& group : _groups)
        if (sharesEye(*group)) return *group;
    // The camera takes its group along, unless another camera has moved the group in this frame.
    if (own && (own->frame != request.frame || own->members.size() == 1))
    {
        own->eye = eye;
        own->hasMoved = true;
        return *own;
    }
    Group& fresh = *_groups.emplace_back(std::make_unique<Group>());
    fresh.view = _follower->addView();
    fresh.eye = eye;
    fresh.buffers = std::make_shared<MtBuffers>();
    return fresh;
}

void MtViewTable::dropUnused(unsigned int frame)
{
    for (const auto& group : _groups)
        std::erase_if(group->members, [](const Member& m) { return m.identity && !m.camera.valid(); });
    std::erase_if(_groups,
                  [&](const std::unique_ptr<Group>& group)
                  {
                      const bool isLeft =
                          osgTraversal::isUnused(group->frame, frame) || group->members.empty();
                      if (isLeft) _follower->removeView(group->view);
                      return isLeft;
                  });
}

core::FollowTarget MtViewTable::strictest(const Group& group)
{
    core::FollowTarget target = group.members.front().target;
    target.eye = group.eye;
    for (const Member& member : group.members)
    {
        target.errorPerDistance = std::min(target.errorPerDistance, member.target.errorPerDistance);
        target.nearest = std::min(target.nearest, member.target.nearest);
    }
    return target;
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
    for (const auto& group : _groups)
        all.push_back({group->frame, static_cast<std::uint32_t>(group->members.size()),
                       group->surface ? static_cast<std::uint32_t>(group->surface->triangles.size()) : 0,
                       group->stallUs});
    return all;
}

void MtViewTable::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (const auto& group : _groups)
        group->buffers->releaseGLObjects(state);
}

} // namespace osgMultiTriangulation
