// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <optional>

#include <osgPMObjects/core/progressive/LevelMesh.h>

#include <osgPMObjects/ProgressiveShape>
#include <osgPMObjects/ProgressiveStatistics>

#include "GpuIndices.h"
#include "ShapeJumps.h"

namespace osgPMObjects
{

/// The index buffer of one view group of an object, and its copies in the graphics contexts.
/// The way to a level that is near is played step by step. One far away is made in one pass, whole; the steps to it are played in the
/// frames that follow, in each at most twice as many as take as long as the pass, and changes are small again after that.
/// Invariant: what is shown is in state `_serial`; packets lead from state to state.
/// Threads: any; the level under one lock, each context's buffer under another that is never held while waiting for the first.
class ViewLevel
{
public:
    explicit ViewLevel(osg::ref_ptr<const ProgressiveShape> shape);

    /// Makes the level after `steps` steps and says what to draw. `contextId`: who will draw, so that it can be given the whole
    /// buffer if it needs it; absent: nobody. The same pointer as long as nothing changes.
    DrawnLevelPtr at(std::uint32_t steps, unsigned int frame, std::optional<unsigned int> contextId);

    /// Uploads what the context lacks and draws one group. A context that has missed packets (its draw was left out, its objects
    /// were released) gets the whole buffer in its present state, and draws that.
    void draw(osg::State& state, const DrawnLevel& drawn, std::uint32_t group);

    /// Calls visit(triangle, group) for each face of the present state, under the lock.
    template<class Visit>
    void visitFaces(const Visit& visit) const
    {
        const std::lock_guard lock(_levelMutex);
        if (!_jumped) return core::forEachDrawnFace(_shape->progressive(), _level, visit);
        for (std::uint32_t group = 0; group < _jumped->groups.size(); ++group)
        {
            const core::SlotRange range = _jumped->groups[group];
            for (std::uint32_t triangle = range.first; triangle < range.first + range.count; ++triangle)
                visit(_jumped->triangle(triangle), group);
        }
    }

    const ProgressiveShape& shape() const { return *_shape; }

    /// Gives back the buffers of one context, or (nullptr) of all.
    void releaseGLObjects(osg::State* state);

    /// Fills in what the level knows: steps, triangles, what was played and uploaded.
    void addTo(ProgressiveViewStatistics& statistics) const;

private:
    /// What a context was handed last.
    struct Given
    {
        std::uint64_t serial = 0;
        unsigned int frame = 0;
        IndexPacketPtr packet;
    };

    std::uint32_t steps() const { return _jumped ? _jumped->steps : _level.steps(); }
    std::uint32_t faceCount() const { return _jumped ? _jumped->triangleCount() : _level.faceCount(); }
    bool isFar(std::uint32_t steps) const;
    bool advance(std::uint32_t steps, unsigned int frame);
    void followJump(std::uint32_t steps, unsigned int frame);
    void playTo(std::uint32_t steps);
    void appendRanges(std::uint32_t group, std::vector<core::SlotRange>& ranges) const;
    IndexPacketPtr packetFor(unsigned int contextId, unsigned int frame);
    IndexPacketPtr packetOf(std::vector<core::SlotRange> ranges, bool isWhole) const;
    IndexPacketPtr wholeNow();
    DrawnLevelPtr drawnWith(IndexPacketPtr packet) const;
    DrawnLevelPtr repair(osg::State& state, GpuIndices& gpu);
    GpuIndices& gpuIndices(unsigned int contextId);

    osg::ref_ptr<const ProgressiveShape> _shape;

    mutable std::mutex _levelMutex; ///< guards everything down to _drawn
    core::ProgressiveLevel _level;
    JumpedLevelPtr _jumped;      ///< shown as long as `_level` is not there
    unsigned int _jumpFrame = 0; ///< `_level` has been moved in it
    std::uint32_t _jumps = 0;
    std::uint64_t _serial = 0;
    IndexPacketPtr _changed,
        _whole; ///< to _serial from the state before, and from nothing: made when asked for
    std::map<unsigned int, Given> _given;
    DrawnLevelPtr _drawn;

    mutable std::mutex
        _gpuMutex; ///< guards the map and the number; each GpuIndices belongs to its draw thread
    std::map<unsigned int, std::unique_ptr<GpuIndices>> _gpu;
    std::size_t _bytesUploaded = 0;
};

} // namespace osgPMObjects
