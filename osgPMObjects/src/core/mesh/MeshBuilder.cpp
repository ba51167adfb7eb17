// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/mesh/MeshBuilder.h>

namespace osgPMObjects::core
{

namespace
{

std::uint64_t hashOf(const glm::dvec3& p)
{
    return stir(stir(stir(0, bitsOf(p.x)), bitsOf(p.y)), bitsOf(p.z));
}

} // namespace

std::uint32_t MeshBuilder::position(const glm::dvec3& where)
{
    std::vector<glm::dvec3>& all = _mesh.positions;
    const auto next = static_cast<std::uint32_t>(all.size());
    const std::uint32_t found = _positions.findOrAdd(
        next, hashOf(where), [&](std::uint32_t i) { return all[i] == where; },
        [&](std::uint32_t i) { return hashOf(all[i]); });
    if (found == next) all.push_back(where);
    return found;
}

std::uint32_t MeshBuilder::material(const Material& material)
{
    std::vector<Material>& all = _mesh.materials;
    const auto found = std::find(all.begin(), all.end(), material);
    if (found != all.end()) return static_cast<std::uint32_t>(found - all.begin());
    all.push_back(material);
    return static_cast<std::uint32_t>(all.size() - 1);
}

std::uint32_t MeshBuilder::part(const std::string& name)
{
    _mesh.parts.push_back({name});
    return static_cast<std::uint32_t>(_mesh.parts.size() - 1);
}

} // namespace osgPMObjects::core
