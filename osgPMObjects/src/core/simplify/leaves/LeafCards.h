// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

#include "../parts/ConnectedParts.h"

namespace osgPMObjects::core
{

/// A small flat part that is one of very many: a leaf, a twig with its leaves, a blade of grass.
struct LeafCard
{
    static constexpr std::size_t kMostCorners = 8;

    struct Corner
    {
        std::uint32_t position = 0;
        std::vector<std::uint32_t> wedges; ///< that faces of the card have there
    };
    using Corners = std::array<std::uint8_t, 3>; ///< of a face, by number

    std::uint32_t part = 0;
    std::vector<Corner> corners;
    std::vector<Corners> faces;
};

/// The cards of each material that is foliage, in the order of their parts; none of any other material. A material is foliage when
/// nearly all of its area is at least 64 connected parts of at most eight faces, flat, of about one size, each small against the mesh, that
/// show the same few cuts of a texture and look in so many directions that they are no tiles of a wall or a deck.
/// `positions`: of the mesh, in a frame where its diagonal is 1; `partOf`: by position. Cost: linear.
std::vector<std::vector<LeafCard>> leafCards(const Mesh& mesh, std::span<const glm::dvec3> positions,
                                             std::span<const ConnectedPart> parts,
                                             std::span<const std::uint32_t> partOf);

} // namespace osgPMObjects::core
