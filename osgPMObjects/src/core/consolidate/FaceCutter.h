// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// A vertex on a side of a face, with its place along that side.
struct OnSide
{
    std::uint32_t position;
    float along; ///< 0…1 from the side's first corner to its second
};

/// A face with the vertices that are to be put into its sides.
struct CrowdedFace
{
    std::array<std::uint32_t, 3> wedges;
    std::array<std::vector<OnSide>, 3> onSide; ///< in order along the side
};

/// Wedges in the middle of edges: one for each pair of ends and position, so that faces that shared an edge share its parts.
/// Attributes are interpolated linearly, normals too, whose length is left: so the rasteriser shows what it showed.
class EdgeWedges
{
public:
    explicit EdgeWedges(Mesh& mesh) : _mesh(mesh) {}
    std::uint32_t between(std::uint32_t from, std::uint32_t to, const OnSide& at);

private:
    Mesh& _mesh;
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> _known;
};

/// Cuts a crowded face at the middle vertex of its most crowded side, from the opposite corner, until each piece has its three
/// corners alone; the pieces, otherwise like `pattern`, are added to `into`.
void cutFace(const CrowdedFace& face, const Face& pattern, EdgeWedges& wedges, std::vector<Face>& into);

} // namespace osgPMObjects::core
