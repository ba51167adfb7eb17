// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// A vertex on a side of a face, with its parameter along the side.
struct OnSide
{
    std::uint32_t position;
    float along; ///< 0…1 from the side's first corner to its second
};

/// A face with the vertices to insert into its sides.
struct CrowdedFace
{
    std::array<std::uint32_t, 3> wedges;
    std::array<std::vector<OnSide>, 3> onSide; ///< in order along the side
};

/// The wedges inside edges: one for each pair of ends and position, so that faces that shared an edge share
/// its parts. Attributes are interpolated linearly, and normals not normalised, as the rasteriser does, so
/// the image does not change.
class EdgeWedges
{
public:
    explicit EdgeWedges(Mesh& mesh) : _mesh(mesh) {}
    std::uint32_t between(std::uint32_t from, std::uint32_t to, const OnSide& at);

private:
    Mesh& _mesh;
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> _known;
};

/// Cuts a face at the middle vertex of its side with most vertices, from the opposite corner, and so on until
/// each piece is a triangle without other vertices. The pieces, otherwise like `pattern`, are appended to
/// `into`.
void cutFace(const CrowdedFace& face, const Face& pattern, EdgeWedges& wedges, std::vector<Face>& into);

} // namespace osgPMObjects::core
