// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <osgTerrainROAM/core/vdpm/VertexForest.h>

namespace osgTerrainROAM::core
{

/// The mesh that a vertex forest is refined to now: the active vertices (the front) and their faces. vsplit()
/// and ecol() move the front down and up. Vertices and faces lie in pools of slots. Slots of faces have no
/// gaps: the last face moves into the slot of one that goes.
/// Invariant: defect() is empty after every operation. Threads: one. Memory: 12 B for each vertex of the
/// forest and 40 B for each face of the mesh; operations allocate only to grow a pool.
/// Source: Hoppe, *View-dependent refinement of progressive meshes*, 1997, section 3.1 (legality), 4.1
/// (forced vsplits).
class ActiveFront
{
public:
    struct Face
    {
        std::uint32_t number = kNone;
        std::array<std::uint32_t, 3> corners{}; ///< slots of vertices, counter-clockwise
        std::array<std::uint32_t, 3>
            across{}; ///< by side from corner i to the next: number of the face, or kNone
    };

    explicit ActiveFront(const VertexForest& forest);

    const VertexForest& forest() const { return *_forest; }
    bool isActive(std::uint32_t vertex) const { return _slotOfVertex[vertex] != kNone; }
    bool isPresent(std::uint32_t face) const { return _slotOfFace[face] != kNone; }
    bool isDone(std::uint32_t split) const { return isActive(_forest->v0(split)); }

    /// A vsplit is legal when the node of v1 that it splits is active, and f0…f3 are in the mesh.
    bool isVsplitLegal(std::uint32_t split) const;

    /// An ecol is legal when both nodes that its vsplit has made are active, and fL, fR are in the mesh with
    /// f0…f3 as neighbours.
    bool isEcolLegal(std::uint32_t split) const;

    /// Precondition: it is legal.
    void vsplit(std::uint32_t split);
    void ecol(std::uint32_t split);

    /// Does a vsplit, and before it those that make it legal. Cost: linear in what is done.
    void forceVsplit(std::uint32_t split);

    std::uint32_t faceCount() const { return static_cast<std::uint32_t>(_faces.size()); }
    std::uint32_t vertexSlots() const { return static_cast<std::uint32_t>(_vertices.size()); }
    std::uint32_t vertexCount() const { return _vertexCount; }
    const Face& faceAt(std::uint32_t slot) const { return _faces[slot]; }
    std::uint32_t slotOfFace(std::uint32_t face) const { return _slotOfFace[face]; }
    std::uint32_t slotOfVertex(std::uint32_t vertex) const { return _slotOfVertex[vertex]; }

    /// The vertex in a slot; kNone: the slot is free.
    std::uint32_t vertexAt(std::uint32_t slot) const { return _vertices[slot].number; }

    /// The slots that operations have written since clearChanges().
    const MeshChanges& changes() const { return _changes; }
    void clearChanges() { _changes.clear(); }

    /// Records a vertex that is drawn at another place than before.
    void touch(std::uint32_t vertex) { _changes.vertices.push_back(_slotOfVertex[vertex]); }

    /// Leaves out of the changes slots of faces that are used no more.
    void trimChanges()
    {
        std::erase_if(_changes.triangles, [this](std::uint32_t slot) { return slot >= _faces.size(); });
    }

    /// Describes the first defect that a brute-force check of all vertices, faces and links finds; empty:
    /// none. Cost: linear.
    std::string defect() const;
    bool isConforming() const { return defect().empty(); }

    std::size_t memoryBytes() const;

private:
    struct Vertex
    {
        std::uint32_t number = kNone;
        std::uint32_t nextSplit = kNone; ///< the split of the active node; of a free slot: the next free slot
    };

    Face& face(std::uint32_t number) { return _faces[_slotOfFace[number]]; }
    const Face& face(std::uint32_t number) const { return _faces[_slotOfFace[number]]; }
    std::uint32_t nextSplitOf(std::uint32_t vertex) const
    {
        return _vertices[_slotOfVertex[vertex]].nextSplit;
    }
    std::uint32_t addVertex(std::uint32_t number);
    void removeVertex(std::uint32_t number);
    void addFace(const Face& face);
    void removeFace(std::uint32_t number);
    void replaceInFan(const VertexSplit& split, std::uint32_t from, std::uint32_t to);
    void linkSide(std::uint32_t face, std::uint32_t fromCorner, std::uint32_t to);
    std::uint32_t firstMissing(std::uint32_t split) const;
    std::uint32_t fanOf(const Face& first, std::uint32_t corner) const;
    std::string defectOfVertices() const;
    std::string defectOfFaces() const;
    std::string defectOfSplits() const;

    const VertexForest* _forest;
    std::vector<std::uint32_t> _slotOfVertex, _slotOfFace; ///< by number, kNone: not in the mesh
    std::vector<Vertex> _vertices;                         ///< by slot
    std::vector<Face> _faces;                              ///< by slot
    std::uint32_t _firstFree = kNone, _vertexCount = 0;
    MeshChanges _changes;
    std::vector<std::uint32_t> _forced; ///< memory of forceVsplit()
};

} // namespace osgTerrainROAM::core
