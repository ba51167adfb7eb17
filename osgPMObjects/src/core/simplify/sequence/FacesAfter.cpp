// SPDX-License-Identifier: Apache-2.0
#include "FacesAfter.h"

#include <numeric>

#include <osgPMObjects/core/mesh/MeshCounts.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns 0, 1, 2, …
std::vector<std::uint32_t> themselves(std::size_t count)
{
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

} // namespace

FacesAfter::FacesAfter(const Mesh& mesh, const CollapseSequence& sequence, std::size_t steps)
    : wedges(themselves(mesh.wedgeCount())), isLeft(mesh.faces.size())
{
    // Positions decide whether a face has vanished. Wedges cannot: steps do not update those of vanished
    // faces, so two at one position may separate again.
    std::vector<std::uint32_t> positions = themselves(mesh.positions.size());
    for (std::size_t step = steps; step-- > 0;) // backwards, so that replacements are final
    {
        positions[sequence.steps[step].from] = positions[sequence.steps[step].to];
        for (const WedgeCollapse& wedge : sequence.wedgesOf(step))
            wedges[wedge.from] = wedges[wedge.to];
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        const Face& face = mesh.faces[f];
        isLeft[f] = !repeatsCorner({positions[mesh.positionOf(face, 0)], positions[mesh.positionOf(face, 1)],
                                    positions[mesh.positionOf(face, 2)]});
    }
}

} // namespace osgPMObjects::core
