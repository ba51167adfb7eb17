// SPDX-License-Identifier: Apache-2.0
#include "OuterMesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace osgTerrainROAM
{

namespace
{

constexpr int kBlockCells = 8;

/// The grid lines of the mesh along one axis. Those within the data, the border included, lie on samples.
struct Lines
{
    std::vector<double> at;
    int first = 0, last = 0; ///< the lines on the border of the data

    Lines(const OuterAxis& axis, int cellSide)
    {
        constexpr int kInside = OuterAxis::kInside / 4;
        std::vector<int> beyond{1, 2, 3};
        for (int k = 4; k <= OuterAxis::kOutside; k += 4)
            beyond.push_back(k);
        for (auto k = beyond.rbegin(); k != beyond.rend(); ++k)
            at.push_back(axis.gridAt(OuterAxis::kOutside - *k));
        first = static_cast<int>(at.size());
        const auto samples = std::lround(axis.last() / cellSide);
        const auto cells = std::min<long>(kInside, samples);
        for (long i = 0; i <= cells; ++i)
            at.push_back(static_cast<double>((i * samples + cells / 2) / cells * cellSide));
        last = static_cast<int>(at.size()) - 1;
        for (const int k : beyond)
            at.push_back(axis.gridAt(OuterAxis::kOutside + OuterAxis::kInside + k));
    }

    int cells() const { return static_cast<int>(at.size()) - 1; }
    bool isInside(int cell) const { return cell >= first && cell < last; }
};

class MeshBuilder
{
public:
    MeshBuilder(const OuterGround& ground, const OuterAxis& columns, const OuterAxis& rows)
        : _ground(ground),
          _cell(ground.tile().grid().cellSide()),
          _x(columns, _cell),
          _y(rows, _cell),
          _wallM(std::max(30.0, 4.0 * ground.spacingM()))
    {
        for (int y = 0; y < _y.cells(); y += kBlockCells)
            for (int x = 0; x < _x.cells(); x += kBlockCells)
                addBlock(x, y);
        mesh.packet.serial = 1;
        mesh.packet.whole = true;
        mesh.packet.vertexCount = static_cast<std::uint32_t>(mesh.packet.vertices.size());
        mesh.packet.triangleCount = static_cast<std::uint32_t>(mesh.packet.triangles.size());
        mesh.packet.vertexRanges = {{0, mesh.packet.vertexCount}};
        mesh.packet.triangleRanges = {{0, mesh.packet.triangleCount}};
    }

    OuterMesh mesh;

private:
    using Vertex = std::uint32_t;

    void addBlock(int firstX, int firstY)
    {
        const auto before = static_cast<std::uint32_t>(mesh.packet.triangles.size());
        for (int y = firstY; y < std::min(firstY + kBlockCells, _y.cells()); ++y)
            for (int x = firstX; x < std::min(firstX + kBlockCells, _x.cells()); ++x)
                addCell(x, y);
        const auto count = static_cast<std::uint32_t>(mesh.packet.triangles.size()) - before;
        if (count == 0) return;
        osg::BoundingBox box;
        for (std::uint32_t t = before; t < before + count; ++t)
            for (const Vertex v : mesh.packet.triangles[t].vertices)
            {
                const glm::dvec3 p = core::positionOf(mesh.packet.vertices[v], OuterMesh::kStepM);
                box.expandBy(osg::Vec3d(p.x, p.y, p.z));
            }
        mesh.blocks.push_back({{before, count}, box});
    }

    void addCell(int x, int y)
    {
        const bool insideX = _x.isInside(x), insideY = _y.isInside(y);
        if (insideX && insideY) return;
        const glm::dvec2 corners[4] = {{_x.at[x], _y.at[y]},
                                       {_x.at[x + 1], _y.at[y]},
                                       {_x.at[x + 1], _y.at[y + 1]},
                                       {_x.at[x], _y.at[y + 1]}};
        // The side that lies on the border, counted as the corners from which they start.
        int rim = -1;
        if (insideX && y == _y.last) rim = 0;
        if (insideX && y + 1 == _y.first) rim = 2;
        if (insideY && x == _x.last) rim = 3;
        if (insideY && x + 1 == _x.first) rim = 1;
        if (rim >= 0)
            return addRimCell(corners[rim], corners[(rim + 1) % 4], corners[(rim + 2) % 4],
                              corners[(rim + 3) % 4]);
        const Vertex v[4] = {vertex(corners[0]), vertex(corners[1]), vertex(corners[2]), vertex(corners[3])};
        addTriangle(v[0], v[1], v[2]);
        addTriangle(v[0], v[2], v[3]);
    }

    /// A cell from `a` to `b` along the border, where it has every sample, and from `c` back to `d`;
    /// counter-clockwise.
    void addRimCell(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
    {
        const auto steps = std::max(1L, std::lround(glm::length(b - a) / _cell));
        const Vertex towardsA = vertex(d), towardsB = vertex(c);
        const glm::dvec2 stepAlong = (b - a) / static_cast<double>(steps);
        Vertex before = vertex(a);
        const Vertex middle = vertex(a + stepAlong * static_cast<double>(steps / 2));
        addTriangle(middle, towardsB, towardsA);
        for (long i = 1; i <= steps; ++i)
        {
            const Vertex here = vertex(a + stepAlong * static_cast<double>(i));
            addTriangle(before, here, i <= steps / 2 ? towardsA : towardsB);
            const Vertex low = lowered(before), lowHere = lowered(here);
            addTriangle(before, low, here);
            addTriangle(here, low, lowHere);
            addTriangle(before, here, low);
            addTriangle(here, lowHere, low);
            before = here;
        }
    }

    void addTriangle(Vertex a, Vertex b, Vertex c) { mesh.packet.triangles.push_back({{a, b, c}}); }

    Vertex vertex(const glm::dvec2& grid)
    {
        const auto [found, isNew] = _vertices.try_emplace({grid.x, grid.y}, 0u);
        if (isNew) found->second = push(grid, _ground.at(grid).heightM);
        return found->second;
    }

    Vertex lowered(Vertex above)
    {
        const auto [found, isNew] = _lowered.try_emplace(above, 0u);
        if (isNew)
        {
            core::MeshVertex low = mesh.packet.vertices[above];
            low.position.z -= static_cast<int>(std::lround(_wallM / OuterMesh::kStepM));
            found->second = static_cast<Vertex>(mesh.packet.vertices.size());
            mesh.packet.vertices.push_back(low);
        }
        return found->second;
    }

    Vertex push(const glm::dvec2& grid, double heightM)
    {
        const glm::dvec3 position = _ground.position(grid, heightM) / OuterMesh::kStepM;
        const glm::i64vec2 point(glm::round(grid));
        mesh.packet.vertices.push_back(
            {glm::ivec3(glm::round(position)), glm::u16vec2(point.x & 0xffff, point.y & 0xffff)});
        return static_cast<Vertex>(mesh.packet.vertices.size() - 1);
    }

    const OuterGround& _ground;
    int _cell;
    Lines _x, _y;
    double _wallM;
    std::map<std::pair<double, double>, Vertex> _vertices;
    std::map<Vertex, Vertex> _lowered;
};

} // namespace

OuterMesh outerMesh(const OuterGround& ground, const OuterAxis& columns, const OuterAxis& rows)
{
    return std::move(MeshBuilder(ground, columns, rows).mesh);
}

} // namespace osgTerrainROAM
