// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec3.hpp>

namespace osgTerrainROAM::core
{

constexpr std::uint32_t kNoSide = 0xffffffffu;

/// A mesh of faces with any number of corners: a cube, a TIN, an overhang; closed or with borders.
/// Invariant: each side of a face has at most one twin, which runs the other way.
/// A *side* is a half-edge: sides are numbered face by face, in the order of the corners, from which they
/// lead to the next corner.
class CoarseMesh
{
public:
    /// `faces`: corners of each, counter-clockwise seen from outside; at least three, none twice. Errors: a
    /// face that is none; an edge that three faces have, or two in the same direction. `place`: what errors
    /// name.
    static foundation::Result<CoarseMesh> make(std::vector<glm::dvec3> points,
                                               const std::vector<std::vector<std::uint32_t>>& faces,
                                               const std::string& place);

    std::uint32_t sides() const { return static_cast<std::uint32_t>(_origin.size()); }
    std::uint32_t faces() const { return static_cast<std::uint32_t>(_centres.size()); }
    std::uint32_t next(std::uint32_t side) const;
    std::uint32_t previous(std::uint32_t side) const;
    std::uint32_t twin(std::uint32_t side) const { return _twin[side]; } ///< kNoSide at a border
    std::uint32_t origin(std::uint32_t side) const { return _origin[side]; }
    std::uint32_t face(std::uint32_t side) const { return _face[side]; }

    std::span<const glm::dvec3> points() const { return _points; }
    const glm::dvec3& centre(std::uint32_t face) const { return _centres[face]; } ///< mean of its corners

private:
    foundation::Outcome pair(const std::string& place);

    std::vector<glm::dvec3> _points, _centres;
    std::vector<std::uint32_t> _firstSide; ///< by face, and one more
    std::vector<std::uint32_t> _origin, _twin, _face;
};

/// The six faces of the cube from −1 to 1.
CoarseMesh cubeMesh();

} // namespace osgTerrainROAM::core
