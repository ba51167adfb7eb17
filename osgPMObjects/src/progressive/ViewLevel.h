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
/// A near level is reached step by step. A distant one is made in one pass, as a whole; its steps are applied
/// in the frames that follow, in each at most twice as many as take as long as the pass; after that, changes
/// are small again.
/// Invariant: the level that is shown is state `_serial`; packets lead from state to state.
/// Threads: any. One lock guards the level, another one each context's buffer; the second is never held while
/// waiting for the first.
class ViewLevel
{
public:
    explicit ViewLevel(osg::ref_ptr<const ProgressiveShape> shape);

    /// Makes the level after `steps` steps and returns what to draw, the same pointer as long as nothing
    /// changes. `contextId`: the context that will draw, so that it is given the whole buffer if it needs it;
    /// absent: none.
    DrawnLevelPtr at(std::uint32_t steps, unsigned int frame, std::optional<unsigned int> contextId);

    /// Uploads what the context lacks and draws one group. A context that missed packets, because its draw
    /// was left out or its objects were released, gets the whole buffer in its present state and draws that.
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

    /// Releases the buffers of one context, or with nullptr of all.
    void releaseGLObjects(osg::State* state);

    /// Fills in the statistics of the level: steps, triangles, what was applied and uploaded.
    void addTo(ProgressiveViewStatistics& statistics) const;

private:
    /// What a context was given last.
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
    JumpedLevelPtr _jumped;      ///< shown until `_level` has reached it
    unsigned int _jumpFrame = 0; ///< in which `_level` moved last
    std::uint32_t _jumps = 0;
    std::uint64_t _serial = 0;
    IndexPacketPtr _changed,
        _whole; ///< from the state before to _serial, and from nothing; made when asked for
    std::map<unsigned int, Given> _given;
    DrawnLevelPtr _drawn;

    mutable std::mutex
        _gpuMutex; ///< guards the map and the number; each GpuIndices belongs to its draw thread
    std::map<unsigned int, std::unique_ptr<GpuIndices>> _gpu;
    std::size_t _bytesUploaded = 0;
};

} // namespace osgPMObjects
