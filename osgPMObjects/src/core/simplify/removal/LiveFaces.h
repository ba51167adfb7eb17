// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// The faces of the current level, with lists of those around each position. A face has a slot as long as it
/// exists; slots are reused, so memory does not grow with the steps.
/// Memory: 64 B a face. Cost: constant to add or remove.
class LiveFaces
{
public:
    static constexpr std::uint32_t kNone = ~0u;

    explicit LiveFaces(const Mesh& mesh);

    /// Adds a face under its number; faces of the mesh are numbered from 0.
    void add(const Face& face, std::uint32_t number);
    void remove(std::uint32_t slot);

    const Triangle& triangle(std::uint32_t slot) const { return _slots[slot].corners; }
    const Face& face(std::uint32_t slot) const { return _slots[slot].face; }
    std::uint32_t number(std::uint32_t slot) const { return _slots[slot].number; }

    /// The number of faces around a position; a face that uses it twice counts twice.
    std::uint32_t degree(std::uint32_t position) const { return _degree[position]; }
    std::size_t facesOf(std::uint32_t material) const { return _ofMaterial[material]; }
    const Mesh& mesh() const { return _mesh; }
    const glm::dvec3& at(std::uint32_t position) const { return _mesh.positions[position]; }

    /// Calls visit(slot, corner) for every face around a position.
    template<class Visit>
    void visit(std::uint32_t position, const Visit& visit) const
    {
        for (HalfEdge corner = _first[position]; corner != kNone; corner = next(corner))
            visit(faceOf(corner), cornerOf(corner));
    }

private:
    struct alignas(64) Slot // one cache line
    {
        Triangle corners;
        Face face;
        std::uint32_t number;
        Triangle next, previous; ///< in the list of the corner's position
    };

    std::uint32_t& next(HalfEdge corner) { return _slots[faceOf(corner)].next[cornerOf(corner)]; }
    std::uint32_t next(HalfEdge corner) const { return _slots[faceOf(corner)].next[cornerOf(corner)]; }
    std::uint32_t& previous(HalfEdge corner) { return _slots[faceOf(corner)].previous[cornerOf(corner)]; }

    const Mesh& _mesh;
    std::vector<Slot> _slots;
    std::vector<std::uint32_t> _freeSlots;
    std::vector<HalfEdge> _first; ///< by position
    std::vector<std::uint32_t> _degree;
    std::vector<std::size_t> _ofMaterial;
};

} // namespace osgPMObjects::core
