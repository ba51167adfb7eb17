// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "LiveFaces.h"

namespace osgPMObjects::core
{

/// The groups of faces of a mesh that share positions, which go as a whole when they are too small to matter.
/// Groups only come apart as positions are removed, they never join; what was one group stays one here.
class PartRemoval
{
public:
    /// `isSupport`: by position, or empty.
    PartRemoval(const LiveFaces& live, const std::vector<bool>& isSupport);

    std::uint32_t count() const { return static_cast<std::uint32_t>(_parts.size()); }

    /// Of the box around a group of the mesh: nothing that is left of it is larger.
    double diagonal(std::uint32_t part) const { return _parts[part].diagonal; }

    /// Those that the mesh's faces use, in rising order.
    std::span<const std::uint32_t> positionsOf(std::uint32_t part) const;

    /// Whether the group can go: it has no support vertex, and without it a face of each material is left.
    bool mayGo(std::uint32_t part) const;

private:
    struct Part
    {
        std::uint32_t first = 0; ///< in _positions
        double diagonal = 0.0;
        bool hasSupport = false;
    };

    const LiveFaces& _live;
    std::vector<std::uint32_t> _positions; ///< by group
    std::vector<Part> _parts;
};

} // namespace osgPMObjects::core
