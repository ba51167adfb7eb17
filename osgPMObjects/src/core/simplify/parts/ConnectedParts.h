// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// A set of faces that are connected by common positions.
struct ConnectedPart
{
    std::vector<std::uint32_t> positions; ///< sorted
    std::uint32_t faces = 0;              ///< number of faces left; counted down by collapses
    double doubleArea = 0.0;
    /// distance of its farthest position from all other parts, at most its own size: the error of removing it
    double reach = 0.0;
    /// A material whose last face this part keeps, since it has most of its area.
    struct Kept
    {
        std::uint32_t material = 0;
        std::uint32_t faces = 0; ///< number of faces left in this part
        double doubleArea = 0.0; ///< twice the area of the material in the whole mesh, at the start
        double contrast = 1.0;   ///< to the most similar material of larger area, see materialContrasts()
    };
    std::vector<Kept> kept;
};

/// Finds the connected parts of a mesh, in the order of their lowest positions. `positions`: those of the
/// mesh, in the unit wanted for areas and distances. `colours`: by material; empty: unknown. Cost: n log n,
/// and some microseconds a part.
std::vector<ConnectedPart> connectedParts(const Mesh& mesh, std::span<const glm::dvec3> positions,
                                          std::span<const glm::vec3> colours = {});

/// Returns the mean size of the boxes of parts, weighted by area; 0 without parts.
double meanSize(std::span<const ConnectedPart> parts, std::span<const glm::dvec3> positions);

/// Returns the part of each position; ~0 where there is no face.
std::vector<std::uint32_t> partNumbers(std::span<const ConnectedPart> parts, std::size_t positionCount);

} // namespace osgPMObjects::core
