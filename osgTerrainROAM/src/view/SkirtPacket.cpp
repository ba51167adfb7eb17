// SPDX-License-Identifier: Apache-2.0
#include "SkirtPacket.h"

#include <algorithm>
#include <utility>

namespace osgTerrainROAM
{

namespace
{

/// A point on the border: a vertex, or between two.
struct EdgePlace
{
    core::MeshVertex vertex;
    double column, row;
};

/// One of the four sides: points with share() > 0 are inside.
struct Side
{
    bool isRow;  ///< of constant row
    double line; ///< that row, or column
    double inwards;

    double share(core::GridPoint p) const { return inwards * ((isRow ? p.row : p.column) - line); }
};

class SkirtCollector
{
public:
    SkirtCollector(const core::TerrainMesh& mesh, const std::function<double(const glm::dvec3&)>& depthM)
        : _mesh(mesh),
          _tile(mesh.tile().tile),
          _depthM(depthM),
          _sides{{false, 0.0, 1.0},
                 {true, 0.0, 1.0},
                 {false, _tile.grid().dataColumns() - 1.0, -1.0},
                 {true, _tile.grid().dataRows() - 1.0, -1.0}}
    {
        mesh.forEachTriangleAtBorder(
            [this](const core::GridPoint(&corners)[3], const core::LeafTriangle& triangle)
            {
                for (const Side& side : _sides)
                    addEdge(side, corners, triangle);
            });
    }

    MeshPacket packet;

private:
    /// Where a triangle that lies inside, in part at least, meets the line.
    void addEdge(const Side& side, const core::GridPoint (&corners)[3], const core::LeafTriangle& leaf)
    {
        const double shares[3] = {side.share(corners[0]), side.share(corners[1]), side.share(corners[2])};
        if (*std::max_element(shares, shares + 3) <= 0.0) return;
        EdgePlace ends[3];
        int found = 0;
        for (int i = 0; i < 3; ++i)
        {
            const int j = (i + 1) % 3;
            if (shares[i] == 0.0)
                ends[found++] = between(corners[i], corners[i], leaf.vertices[i], leaf.vertices[i], 0.0);
            else if (shares[i] * shares[j] < 0.0)
                ends[found++] = between(corners[i], corners[j], leaf.vertices[i], leaf.vertices[j],
                                        shares[i] / (shares[i] - shares[j]));
        }
        if (found != 2) return;
        // Counter-clockwise around the data: the wall faces outwards.
        if (along(side, ends[0]) > along(side, ends[1])) std::swap(ends[0], ends[1]);
        addWall(ends[0], ends[1]);
    }

    static double along(const Side& side, const EdgePlace& place)
    {
        return side.inwards * (side.isRow ? place.column : -place.row);
    }

    core::MeshVertex vertex(std::uint32_t slot)
    {
        _one.clear();
        _mesh.appendVertices({slot, 1}, _one);
        return _one.front();
    }

    EdgePlace between(core::GridPoint a, core::GridPoint b, std::uint32_t from, std::uint32_t to, double t)
    {
        const core::MeshVertex u = vertex(from), v = vertex(to);
        EdgePlace place;
        place.vertex.position =
            glm::ivec3(glm::round(glm::mix(glm::dvec3(u.position), glm::dvec3(v.position), t)));
        place.column = a.column + t * (b.column - a.column);
        place.row = a.row + t * (b.row - a.row);
        place.vertex.grid = glm::u16vec2(glm::ivec2(glm::round(glm::dvec2(place.column, place.row))));
        return place;
    }

    core::MeshVertex lowered(const EdgePlace& place) const
    {
        const double stepM = _tile.frame().vertexStepM();
        glm::dvec3 up(0.0, 0.0, 1.0);
        if (_tile.frame().placement() == core::Placement::curved)
            up = _tile.frame().positionAt(place.column, place.row, 1.0) -
                 _tile.frame().positionAt(place.column, place.row, 0.0);
        const double depthM = _depthM(core::positionOf(place.vertex, stepM));
        core::MeshVertex vertex = place.vertex;
        vertex.position -= glm::ivec3(glm::round(up * (depthM / stepM)));
        return vertex;
    }

    void addWall(const EdgePlace& a, const EdgePlace& b)
    {
        const auto first = static_cast<std::uint32_t>(packet.vertices.size());
        packet.vertices.insert(packet.vertices.end(), {a.vertex, b.vertex, lowered(a), lowered(b)});
        packet.triangles.push_back({{first, first + 2, first + 1}});
        packet.triangles.push_back({{first + 1, first + 2, first + 3}});
    }

    const core::TerrainMesh& _mesh;
    const core::PlacedTile& _tile;
    const std::function<double(const glm::dvec3&)>& _depthM;
    Side _sides[4];
    std::vector<core::MeshVertex> _one;
};

} // namespace

PacketPtr skirtPacket(const core::TerrainMesh& mesh, std::uint64_t serial,
                      const std::function<double(const glm::dvec3&)>& depthM)
{
    if (mesh.patches()) return nullptr;
    MeshPacket packet = std::move(SkirtCollector(mesh, depthM).packet);
    packet.serial = serial;
    packet.whole = true;
    packet.vertexCount = static_cast<std::uint32_t>(packet.vertices.size());
    packet.triangleCount = static_cast<std::uint32_t>(packet.triangles.size());
    packet.vertexRanges = {{0, packet.vertexCount}};
    packet.triangleRanges = {{0, packet.triangleCount}};
    return std::make_shared<const MeshPacket>(std::move(packet));
}

} // namespace osgTerrainROAM
