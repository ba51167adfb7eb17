// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects::core
{

/// The faces of any level of a progressive mesh, made in one pass over all faces: those that are left, without holes, in
/// the order that they have at the finest level. For levels far from each other, and for such as stay.
/// Memory: 24 B a face, 8 B a wedge. Nothing is allocated after construction. Cost: linear in the finest level, however far the levels
/// are apart.
/// Threads: one at a time. The mesh has to outlive it, and must not change.
/// Source: "compaction" in Forsyth, "Comparison of VIPM methods" (2001), §4 (skip strips).
class CompactedLevel
{
public:
    explicit CompactedLevel(const ProgressiveMesh& progressive);

    /// Makes the level after so many steps; at most as many as there are.
    void moveTo(std::uint32_t steps);

    std::span<const Triangle> triangles() const { return {_triangles.data(), _live}; } ///< group by group
    /// What triangles a group of faces has.
    SlotRange rangeOf(std::uint32_t group) const;

private:
    /// What a wedge has become, and where that is; of one that became nothing, itself.
    struct Become
    {
        std::uint32_t wedge = 0, position = 0;
    };

    void findWedges(std::uint32_t wedgesLeft);

    const ProgressiveMesh& _progressive;
    std::vector<Triangle> _full;                      ///< the faces of the finest level
    std::vector<std::uint32_t> _fullEnds, _groupEnds; ///< by group, in `_full` and in `_triangles`
    std::vector<Become> _become;                      ///< by wedge
    std::vector<Triangle> _triangles;                 ///< room for all
    std::size_t _live = 0;
};

} // namespace osgPMObjects::core
