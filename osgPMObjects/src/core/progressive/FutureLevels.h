// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <foundation/VertexCache.h>

#include "LevelWalk.h"
#include "Lifetimes.h"

namespace osgPMObjects::core
{

/// Some faces at the present level of a walk and at a few levels to come. It tells what an order of these
/// faces costs a vertex cache until they are reordered. Wedges are numbered from 0 in order of use, so the
/// time does not depend on other faces.
/// Memory: 4 B a wedge of the mesh, 60 B a face taken. Cost: linear in the faces taken.
class FutureLevels
{
public:
    static constexpr std::size_t kLevels = 4;

    FutureLevels(const LevelWalk& walk, std::uint32_t cacheSize);

    /// Takes other faces, all live at the walk's level. `shareGone`: the share of them that vanishes until
    /// the last level.
    void take(std::span<const std::uint32_t> faces, double shareGone);

    /// Returns the triangles of the faces at the present level.
    std::span<const Triangle> present() const { return _levels[0]; }
    std::uint32_t wedgeCount() const { return static_cast<std::uint32_t>(_used.size()); }

    /// Tells whether a face still exists at a level; `face` is its number among the faces taken.
    bool isLive(std::size_t level, std::uint32_t face) const { return _levels[level][face][0] != kNone; }
    const Triangle& triangle(std::size_t level, std::uint32_t face) const { return _levels[level][face]; }

    /// Returns the wedges that are transformed at all levels, when the faces are drawn in this order of their
    /// numbers.
    std::uint64_t costOf(std::span<const std::uint32_t> order);

private:
    static constexpr std::uint32_t kNone = ~0u;

    std::uint32_t numberOf(std::uint32_t wedge);
    void forgetWedges();
    void takePresent(std::span<const std::uint32_t> faces);
    void takeLevel(std::size_t level, std::uint32_t steps, std::span<const std::uint32_t> faces);

    const LevelWalk& _walk;
    Lifetimes _lifetimes;
    foundation::FifoCache _cache;                       ///< of local numbers
    std::array<std::vector<Triangle>, kLevels> _levels; ///< by face: local numbers; kNone: vanished
    std::vector<Triangle> _wedges;                      ///< by face: wedges at the level taken last
    std::vector<std::uint32_t> _numbers;                ///< by wedge: its local number
    std::vector<std::uint32_t> _used;                   ///< wedges with a local number
    std::vector<std::uint32_t> _ends;
};

} // namespace osgPMObjects::core
