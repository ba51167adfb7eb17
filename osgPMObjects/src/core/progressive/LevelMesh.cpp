// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/progressive/LevelMesh.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns the first `count` elements, or all of an array with fewer.
template<class Value>
std::vector<Value> prefixOf(const std::vector<Value>& values, std::size_t count)
{
    return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(std::min(count, values.size()))};
}

} // namespace

Mesh meshAfter(const ProgressiveMesh& progressive, std::uint32_t steps)
{
    ProgressiveLevel level(progressive);
    level.moveTo(std::min(steps, progressive.stepCount));
    const Mesh& full = progressive.mesh;
    const std::size_t wedges = level.wedgeCount();
    Mesh mesh;
    mesh.positions = prefixOf(full.positions, full.positions.size() - level.steps());
    mesh.wedgePositions = prefixOf(full.wedgePositions, wedges);
    mesh.normals = prefixOf(full.normals, wedges);
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        mesh.texCoords[set] = prefixOf(full.texCoords[set], wedges);
    mesh.colours = prefixOf(full.colours, wedges);
    mesh.materials = full.materials;
    mesh.parts = {full.parts.size() == 1 ? full.parts.front() : Part{}};
    forEachDrawnFace(progressive, level,
                     [&](const Triangle& face, std::uint32_t group) {
                         mesh.faces.push_back({face, progressive.groups[group].material, 0});
                     });
    return mesh;
}

} // namespace osgPMObjects::core
