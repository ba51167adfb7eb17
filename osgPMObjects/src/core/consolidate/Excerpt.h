// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Some faces of a mesh and all that share a position with them, as a mesh of its own; what is done to it is put back into the
/// whole. Positions, wedges and faces keep their order, so that work on it does what it would do to them in the whole.
/// Invariant: at an inner position no face is missing, so neither is any on an edge that ends there.
class Excerpt
{
public:
    /// `isWanted`: by face of the whole, 1 for the faces whose corners are to be inner.
    Excerpt(const Mesh& whole, std::span<const std::uint8_t> isWanted);

    Mesh mesh; ///< its materials are those of the whole

    /// By position of the excerpt: 1 where no face is missing.
    const std::vector<std::uint8_t>& isInner() const { return _isInner; }
    /// The position of the whole that one of the excerpt is.
    const std::vector<std::uint32_t>& positions() const { return _positions; }

    /// The faces of the excerpt come to stand where those were that they come of, as `origins` says by face of the excerpt as
    /// it is now: numbers in the excerpt as it was, in order. Positions and wedges may have been moved, wedges added.
    void putBack(Mesh& whole, std::span<const std::uint32_t> origins) const;

private:
    /// Returns the excerpt's positions by number in the whole.
    std::vector<std::uint32_t> takeFaces(const Mesh& whole, std::span<const std::uint8_t> isWanted);
    void takeWedges(const Mesh& whole, std::span<const std::uint32_t> positionNumbers);

    std::vector<std::uint8_t> _isInner;
    std::vector<std::uint32_t> _positions; ///< of the whole, by position of the excerpt
    std::vector<std::uint32_t> _wedges;    ///< the same for wedges
    std::vector<std::uint32_t> _faces;     ///< the same for faces, as it was
};

} // namespace osgPMObjects::core
