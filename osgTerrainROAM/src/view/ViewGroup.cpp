// SPDX-License-Identifier: Apache-2.0
#include "ViewGroup.h"

#include <algorithm>
#include <chrono>

#include "SkirtPacket.h"

namespace osgTerrainROAM
{

namespace
{

double microseconds(std::chrono::steady_clock::duration time)
{
    return std::chrono::duration<double, std::micro>(time).count();
}

double scaleOf(const RefineTarget& target)
{
    if (target.errorM) return 1.0 / *target.errorM;
    return target.view.guaranteedPixelsPerTangent() / target.budget.errorTolerancePx;
}

} // namespace

bool ViewGroup::isMetBy(unsigned int frame, const RefineTarget& target) const
{
    const bool sameKind = _serial != 0 && !_mesh->isBehind() && target.errorM == _target.errorM &&
                          target.isMorphing == _target.isMorphing && target.skirtM == _target.skirtM &&
                          target.view.eyeWorld == _target.view.eyeWorld && target.sight == _target.sight &&
                          target.budget.maxTriangles == _target.budget.maxTriangles;
    if (!sameKind || (_frame != frame && _statistics.refine.sliceBound)) return false;
    const double scale = scaleOf(target);
    const double present = scaleOf(_target);
    // In this frame another camera of the group may have asked for a stricter mesh; a mesh of an older frame
    // must be equal.
    if (_frame == frame && scale <= present && target.view.nearM >= _target.view.nearM) return true;
    return scale == present && target.view.nearM == _target.view.nearM;
}

void ViewGroup::refine(const RefineTarget& target)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    _mesh->setMorphing(target.isMorphing);
    _mesh->setSight(target.sight);
    _statistics.refine =
        target.errorM ? _mesh->refine(*target.errorM) : _mesh->refine(target.view, target.budget);
    const auto refined = Clock::now();
    const core::MeshChanges& changes = _mesh->changes();
    const bool patchesChanged = _mesh->patches() && !_mesh->patches()->written().empty();
    if (_serial == 0 || patchesChanged || !changes.vertices.empty() || !changes.triangles.empty())
    {
        _changed = _serial == 0 ? nullptr : changedPacket(*_mesh, _serial + 1);
        _whole = nullptr;
        ++_serial;
    }
    _statistics.adaptUs = microseconds(refined - start);
    _statistics.packetUs = microseconds(Clock::now() - refined);
    _target = target;
}

ViewAnswer ViewGroup::answer(unsigned int frame, const RefineTarget& target, const viewlod::Frustum& frustum,
                             std::optional<unsigned int> contextId)
{
    const Locked lock(*this);
    if (!isMetBy(frame, target))
        refine(target);
    else if (_frame != frame)
    {
        // The same eye again: refining would find nothing to do.
        _statistics.refine.splits = _statistics.refine.merges = 0;
        _statistics.adaptUs = _statistics.packetUs = 0.0;
    }
    _frame = _statistics.frame = frame;
    const glm::dvec3& eye = target.view.eyeWorld;
    return answerLocked(frustum, eye, _mesh->horizon(eye), contextId);
}

ViewAnswer ViewGroup::answerAsIs(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                                 std::optional<unsigned int> contextId)
{
    const Locked lock(*this);
    return answerLocked(frustum, eye, std::nullopt, contextId);
}

ViewAnswer ViewGroup::answerLocked(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                                   const std::optional<core::Horizon>& horizon,
                                   std::optional<unsigned int> contextId)
{
    ViewAnswer answer;
    answer.triangles = _mesh->visibleRanges(frustum, eye, horizon ? &*horizon : nullptr, answer.ranges);
    answer.nearestM = _mesh->nearestM(eye);
    answer.serial = _serial;
    if (contextId) answer.packet = packetFor(*contextId);
    if (contextId && _target.skirtM) answer.skirt = skirtNow();
    return answer;
}

PacketPtr ViewGroup::packetFor(unsigned int contextId)
{
    PacketPtr& given = _given[contextId];
    if (given && given->serial == _serial) return given;
    const bool follows = given && _changed && given->serial + 1 == _serial &&
                         bufferCapacity(given->vertexCount) == bufferCapacity(_changed->vertexCount) &&
                         bufferCapacity(given->triangleCount) == bufferCapacity(_changed->triangleCount);
    given = follows ? _changed : wholeNow();
    return given;
}

PacketPtr ViewGroup::wholeNow()
{
    if (!_whole) _whole = wholePacket(*_mesh, _serial);
    return _whole;
}

/// Makes the skirt three times as deep as the drawn surface may be off at that distance: the error of this
/// side, that of the other side, and a margin.
PacketPtr ViewGroup::skirtNow()
{
    if (_skirt && _skirt->serial == _serial) return _skirt;
    const double tolerancePx = std::max(_statistics.refine.tolerancePx, _target.budget.errorTolerancePx);
    const double errorPerM = tolerancePx / _target.view.guaranteedPixelsPerTangent();
    const auto depthM = [&](const glm::dvec3& place)
    {
        const double errorM =
            _target.errorM ? *_target.errorM : errorPerM * glm::distance(place, _target.view.eyeWorld);
        return std::max(3.0 * errorM, *_target.skirtM);
    };
    _skirt = skirtPacket(*_mesh, _serial, depthM);
    return _skirt;
}

GpuMesh& ViewGroup::gpuMesh(std::map<unsigned int, std::unique_ptr<GpuMesh>>& meshes, unsigned int contextId)
{
    const std::lock_guard lock(_gpuMutex);
    auto& slot = meshes[contextId];
    if (!slot) slot = std::make_unique<GpuMesh>(contextId);
    return *slot;
}

std::uint32_t ViewGroup::draw(osg::State& state, const ViewAnswer& answer, const viewlod::Frustum& frustum)
{
    GpuMesh* const gpu = &gpuMesh(_gpuMeshes, state.getContextID());
    PacketPtr packet = answer.packet;
    std::vector<core::IndexRange> ranges = answer.ranges;
    std::uint32_t triangles = answer.triangles;
    if (!packet || !gpu->canTake(*packet))
    {
        const Locked lock(*this);
        packet = wholeNow();
        ranges.clear();
        triangles = _mesh->visibleRanges(frustum, ranges);
    }
    std::size_t bytes = gpu->upload(state, *packet);
    gpu->draw(state, ranges);
    if (answer.skirt && answer.skirt->triangleCount > 0)
    {
        GpuMesh& skirt = gpuMesh(_gpuSkirts, state.getContextID());
        bytes += skirt.upload(state, *answer.skirt);
        skirt.draw(state, answer.skirt->triangleRanges);
    }
    const std::lock_guard lock(_gpuMutex);
    _bytesUploaded += bytes;
    _trianglesDrawn = triangles;
    return triangles;
}

void ViewGroup::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_gpuMutex);
    for (const auto* meshes : {&_gpuMeshes, &_gpuSkirts})
        for (auto& [contextId, gpu] : *meshes)
            if (!state || state->getContextID() == contextId) gpu->release();
}

ViewGroupStatistics ViewGroup::statistics() const
{
    ViewGroupStatistics result;
    {
        const std::lock_guard lock(_meshMutex);
        result = _statistics;
    }
    const std::lock_guard lock(_gpuMutex);
    result.bytesUploaded = _bytesUploaded;
    result.trianglesDrawn = _trianglesDrawn;
    return result;
}

} // namespace osgTerrainROAM
