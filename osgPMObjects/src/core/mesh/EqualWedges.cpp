// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/mesh/EqualWedges.h>
#include <osgPMObjects/core/mesh/FirstAtPlace.h>
#include <osgPMObjects/core/mesh/WedgeHash.h>

namespace osgPMObjects::core
{

std::vector<std::uint32_t> firstEqualWedges(const Mesh& mesh)
{
    const std::vector<std::uint32_t> places = firstAtPlace(mesh.positions);
    const auto placed = [&](std::uint32_t w)
    {
        Wedge wedge = wedgeOf(mesh, w);
        wedge.position = places[wedge.position];
        return wedge;
    };
    const auto hashOf = [&](std::uint32_t w) { return hashWedge(placed(w)); };
    HashIndex index(mesh.wedgeCount());
    std::vector<std::uint32_t> first;
    first.reserve(mesh.wedgeCount());
    for (std::uint32_t w = 0; w < mesh.wedgeCount(); ++w)
        first.push_back(index.findOrAdd(
            w, hashOf(w), [&](std::uint32_t i) { return placed(i) == placed(w); }, hashOf));
    return first;
}

} // namespace osgPMObjects::core
