// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

#include "ConnectedParts.h"

namespace osgPMObjects::core
{

/// A small flat connected part, one of very many: a leaf, a twig with leaves, a blade of grass.
struct LeafCard
{
    static constexpr std::size_t kMostCorners = 8;

    struct Corner
    {
        std::uint32_t position = 0;
        std::vector<std::uint32_t> wedges; ///< of the card's faces there
    };
    using Corners = std::array<std::uint8_t, 3>; ///< corner numbers of a face

    std::uint32_t part = 0;
    std::vector<Corner> corners;
    std::vector<Corners> faces;
};

/// Finds the leaf cards of each material of foliage, in the order of their parts; none for other materials. A
/// material is foliage when nearly all of its area consists of at least 64 connected parts that are flat,
/// have at most eight faces, are of about one size and small against the mesh, show the same few regions of a
/// texture, and look in too many directions for tiles of a wall or deck.
/// `positions`: of the mesh, in a frame where its diagonal is 1; `partOf`: by position. Cost: linear.
std::vector<std::vector<LeafCard>> leafCards(const Mesh& mesh, std::span<const glm::dvec3> positions,
                                             std::span<const ConnectedPart> parts,
                                             std::span<const std::uint32_t> partOf);

} // namespace osgPMObjects::core
