// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "StarMesh.h"

namespace osgPMObjects::core
{

/// The faces around a position, gathered for queries. Reused for other positions, so that memory is not
/// allocated again.
struct Star
{
    /// A face, rotated so that the middle position is its first corner.
    struct Spoked
    {
        std::uint32_t face = 0;
        std::uint32_t wedge = 0;  ///< at the middle
        std::uint32_t second = 0; ///< position
        std::uint32_t third = 0;  ///< position
        glm::dvec3 normal{0.0};   ///< of length 1; 0: the face has no area
        double doubleArea = 0.0;

        bool has(std::uint32_t position) const { return second == position || third == position; }
    };

    /// An edge from the middle, with one of its faces. Sorted by `to`.
    struct Side
    {
        std::uint32_t to = 0;
        std::uint32_t spoked = 0; ///< index in `faces`
    };

    std::uint32_t middle = 0;
    std::vector<Spoked> faces;
    std::vector<Side> sides;
    std::vector<std::uint32_t> neighbours; ///< sorted

    void gather(const StarMesh& mesh, std::span<const glm::dvec3> positions, std::uint32_t position);

    /// The sides to one neighbour, beginning at index `at`.
    std::span<const Side> sidesFrom(std::size_t at) const;
    /// The sides to a neighbour; none when there is no edge.
    std::span<const Side> sidesTo(std::uint32_t to) const;
};

} // namespace osgPMObjects::core
