// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "LiveFaces.h"

namespace osgPMObjects::core
{

/// The connected groups of faces of a mesh; a group is removed as a whole when it is too small to matter.
/// Removals may divide groups but never join them; a divided group still counts as one here.
class PartRemoval
{
public:
    /// `isSupport`: by position, or empty.
    PartRemoval(const LiveFaces& live, const std::vector<bool>& isSupport);

    std::uint32_t count() const { return static_cast<std::uint32_t>(_parts.size()); }

    /// The diagonal of the box around a group of the mesh: an upper bound for what is left of it.
    double diagonal(std::uint32_t part) const { return _parts[part].diagonal; }

    /// The positions of a group that the mesh's faces use, in rising order.
    std::span<const std::uint32_t> positionsOf(std::uint32_t part) const;

    /// Whether the group may be removed: it has no support vertex, and every material keeps a face.
    bool mayGo(std::uint32_t part) const;

private:
    struct Part
    {
        std::uint32_t first = 0; ///< index in _positions
        double diagonal = 0.0;
        bool hasSupport = false;
    };

    const LiveFaces& _live;
    std::vector<std::uint32_t> _positions; ///< by group
    std::vector<Part> _parts;
};

} // namespace osgPMObjects::core
