// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <vector>

#include <osg/GLExtensions>
#include <osg/State>

#include <viewlod/Budget.h>
#include <viewlod/Sight.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/TerrainMesh.h>

#include <osgTerrainROAM/RoamStatistics>

#include "GpuMesh.h"
#include "MeshPacket.h"

namespace osgTerrainROAM
{

/// The target of a group's refinement in one frame: the eye that its cameras share, and the strictest of
/// their scales.
struct RefineTarget
{
    viewlod::ViewState view;
    viewlod::Budget budget;
    bool isMorphing = false;
    std::optional<double> skirtM; ///< no skirt is less deep; absent: there are none
    viewlod::Sight sight;         ///< what is refined
    std::optional<double> errorM; ///< of a parallel projection: view-independent refinement instead
};

/// The result of one cull traversal for the draw.
struct ViewAnswer
{
    std::uint64_t serial = 0;             ///< state of the mesh that `ranges` belong to
    PacketPtr packet;                     ///< leads to that state; null when nobody was known to draw
    PacketPtr skirt;                      ///< of that state; null: none
    std::vector<core::IndexRange> ranges; ///< TerrainMesh::visibleRanges()
    std::uint32_t triangles = 0;          ///< in them, gaps not counted
    double nearestM = 0.0;                ///< from the eye to the drawn surface
};

/// The mesh of one view group, and its copies in the graphics contexts.
/// Invariant: the mesh is in state _serial; packets take copies from state to state.
/// Threads: any. _meshMutex guards the mesh; the tile's mutex is taken after it, shared. _gpuMutex guards the
/// map of buffers and the counts, and is not held while another lock is awaited; each GpuMesh belongs to its
/// context's draw thread.
class ViewGroup
{
public:
    explicit ViewGroup(std::unique_ptr<core::TerrainMesh> mesh) : _mesh(std::move(mesh)) {}

    /// Refines for the target, unless this frame's mesh is as strict already, and answers for one frustum.
    /// `contextId`: the context that will draw, which may need the whole mesh; absent: none.
    ViewAnswer answer(unsigned int frame, const RefineTarget& target, const viewlod::Frustum& frustum,
                      std::optional<unsigned int> contextId);

    /// Answers for a camera that borrows another's mesh, without refining it.
    ViewAnswer answerAsIs(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                          std::optional<unsigned int> contextId);

    /// Uploads and draws an answer. A context that has missed packets (its draw was omitted, its objects were
    /// released) gets the whole mesh in its present state, with new ranges. Returns the number of triangles
    /// drawn.
    std::uint32_t draw(osg::State& state, const ViewAnswer& answer, const viewlod::Frustum& frustum);

    /// Calls visit(mesh, ranges) under the lock with ranges that are valid now.
    template<class Visit>
    void visitMesh(const ViewAnswer& answer, const viewlod::Frustum& frustum, Visit visit) const
    {
        const Locked lock(*this);
        if (answer.serial == _serial) return visit(*_mesh, answer.ranges);
        std::vector<core::IndexRange> ranges;
        _mesh->visibleRanges(frustum, ranges);
        visit(*_mesh, ranges);
    }

    /// Threads: any, without the lock.
    const core::PlacedTile& tile() const { return _mesh->tile().tile; }

    /// Calls visit(mesh) under the lock.
    template<class Visit>
    void visitMesh(Visit visit) const
    {
        const Locked lock(*this);
        visit(*_mesh);
    }

    /// Releases the buffers of one context, or (nullptr) of all.
    void releaseGLObjects(osg::State* state);

    ViewGroupStatistics statistics() const;

private:
    /// Locks the mesh, and the tile against edits.
    class Locked
    {
    public:
        explicit Locked(const ViewGroup& group) : _mesh(group._meshMutex), _tile(group._mesh->tile().mutex())
        {
        }

    private:
        std::lock_guard<std::mutex> _mesh;
        std::shared_lock<std::shared_mutex> _tile;
    };

    void refine(const RefineTarget& target);
    ViewAnswer answerLocked(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                            const std::optional<core::Horizon>& horizon,
                            std::optional<unsigned int> contextId);
    PacketPtr packetFor(unsigned int contextId);
    PacketPtr wholeNow();
    PacketPtr skirtNow();
    GpuMesh& gpuMesh(std::map<unsigned int, std::unique_ptr<GpuMesh>>& meshes, unsigned int contextId);
    bool isMetBy(unsigned int frame, const RefineTarget& target) const;

    mutable std::mutex _meshMutex; ///< guards everything down to _statistics
    std::unique_ptr<core::TerrainMesh> _mesh;
    std::uint64_t _serial = 0;
    PacketPtr _changed; ///< to _serial from the state before; null: _whole alone leads there
    PacketPtr _whole;   ///< to _serial from nothing; made when asked for
    PacketPtr _skirt;   ///< of _serial, if its own serial says so; made when asked for
    std::map<unsigned int, PacketPtr> _given; ///< last packet that each context was given
    std::optional<unsigned int> _frame;
    RefineTarget _target; ///< of the last refinement
    ViewGroupStatistics _statistics;

    mutable std::mutex _gpuMutex; ///< guards the map and the numbers; each GpuMesh belongs to its draw thread
    std::map<unsigned int, std::unique_ptr<GpuMesh>> _gpuMeshes, _gpuSkirts;
    std::size_t _bytesUploaded = 0;
    std::uint32_t _trianglesDrawn = 0;
};

} // namespace osgTerrainROAM
