// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <osgPMObjects/core/consolidate/MergeWedges.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kUnused = ~0u;

/// Returns new numbers for marked elements, in order; kUnused for the rest.
std::vector<std::uint32_t> numbered(const std::vector<bool>& isUsed)
{
    std::vector<std::uint32_t> numbers(isUsed.size(), kUnused);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < isUsed.size(); ++i)
        if (isUsed[i]) numbers[i] = next++;
    return numbers;
}

template<class Value>
void keepNumbered(std::vector<Value>& values, const std::vector<std::uint32_t>& numbers)
{
    if (values.empty()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != kUnused) values[kept++] = values[i];
    values.resize(kept);
    values.shrink_to_fit();
}

} // namespace

void compactMesh(Mesh& mesh)
{
    std::vector<bool> isWedgeUsed(mesh.wedgeCount(), false), isPositionUsed(mesh.positions.size(), false);
    for (const Face& face : mesh.faces)
        for (const std::uint32_t wedge : face.wedges)
        {
            isWedgeUsed[wedge] = true;
            isPositionUsed[mesh.wedgePositions[wedge]] = true;
        }
    const auto wedges = numbered(isWedgeUsed), positions = numbered(isPositionUsed);
    for (Face& face : mesh.faces)
        for (std::uint32_t& wedge : face.wedges)
            wedge = wedges[wedge];
    keepNumbered(mesh.wedgePositions, wedges);
    keepNumbered(mesh.normals, wedges);
    for (auto& set : mesh.texCoords)
        keepNumbered(set, wedges);
    keepNumbered(mesh.colours, wedges);
    for (std::uint32_t& position : mesh.wedgePositions)
        position = positions[position];
    keepNumbered(mesh.positions, positions);
}

} // namespace osgPMObjects::core
