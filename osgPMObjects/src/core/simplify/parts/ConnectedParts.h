// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Faces that hang together by positions.
struct ConnectedPart
{
    std::vector<std::uint32_t> positions; ///< sorted
    std::uint32_t faces = 0;              ///< that are left; used up by whoever collapses
    double doubleArea = 0.0;
    double reach =
        0.0; ///< how far its farthest position is from all other parts, at most its own size: what is lost with it
    /// Materials that this part has to keep the last face of, for it has the most of them, and how many faces are left.
    struct Kept
    {
        std::uint32_t material = 0, faces = 0;
    };
    std::vector<Kept> kept;
};

/// The connected parts of a mesh, in the order of their lowest positions. `positions` are the mesh's, in whatever unit the areas
/// and reaches shall have. Cost: n log n; some microseconds a part besides.
std::vector<ConnectedPart> connectedParts(const Mesh& mesh, std::span<const glm::dvec3> positions);

/// By position: its part's number; ~0 where no face is.
std::vector<std::uint32_t> partNumbers(std::span<const ConnectedPart> parts, std::size_t positionCount);

} // namespace osgPMObjects::core
