// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Some faces of a mesh, and all that share a position with them, as a mesh of its own that can be put back
/// after changes. Positions, wedges and faces keep their order, so a change has the same result as in the
/// whole mesh.
/// Invariant: an inner position has all its faces, so each edge that ends there has all its faces, too.
class Excerpt
{
public:
    /// `isWanted`: by face of the whole, 1 for faces whose corners are to be inner positions.
    Excerpt(const Mesh& whole, std::span<const std::uint8_t> isWanted);

    Mesh mesh; ///< its materials are those of the whole

    /// By position of the excerpt: 1 where no face is missing.
    const std::vector<std::uint8_t>& isInner() const { return _isInner; }
    /// By position of the excerpt: its number in the whole.
    const std::vector<std::uint32_t>& positions() const { return _positions; }

    /// Replaces the faces in the whole by those of the excerpt. `origins`: for each current face of the
    /// excerpt, the number of the original face it comes from, rising. Positions and wedges may have moved,
    /// wedges may have been added.
    void putBack(Mesh& whole, std::span<const std::uint32_t> origins) const;

private:
    /// Returns the excerpt's positions by their number in the whole.
    std::vector<std::uint32_t> takeFaces(const Mesh& whole, std::span<const std::uint8_t> isWanted);
    void takeWedges(const Mesh& whole, std::span<const std::uint32_t> positionNumbers);

    std::vector<std::uint8_t> _isInner;
    std::vector<std::uint32_t> _positions; ///< of the whole, by position of the excerpt
    std::vector<std::uint32_t> _wedges;    ///< the same for wedges
    std::vector<std::uint32_t> _faces;     ///< the same for faces, as they were at first
};

} // namespace osgPMObjects::core
