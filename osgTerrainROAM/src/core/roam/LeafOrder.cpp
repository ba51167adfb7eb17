// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <utility>

#include <osgTerrainROAM/core/roam/LeafOrder.h>
#include <osgTerrainROAM/core/roam/TerrainMesh.h>

namespace osgTerrainROAM::core
{

namespace
{

bool isGap(const LeafTriangle& t)
{
    return t.vertices[0] == t.vertices[1] && t.vertices[1] == t.vertices[2];
}

bool has(const LeafTriangle& t, std::uint32_t vertex)
{
    return std::find(std::begin(t.vertices), std::end(t.vertices), vertex) != std::end(t.vertices);
}

/// The corner that is neither of two others.
std::uint32_t thirdCorner(const LeafTriangle& t, std::uint32_t a, std::uint32_t b)
{
    return *std::find_if(std::begin(t.vertices), std::end(t.vertices),
                         [=](std::uint32_t v) { return v != a && v != b; });
}

} // namespace

void LeafOrderMeter::draw(std::span<const LeafTriangle> triangles)
{
    _fifo16.empty();
    _fifo32.empty();
    _batch32.begin();
    _strip = {};
    for (const LeafTriangle& triangle : triangles)
    {
        for (const std::uint32_t vertex : triangle.vertices)
        {
            _fifo16.transform(vertex);
            _fifo32.transform(vertex);
        }
        _batch32.draw(triangle.vertices);
        if (isGap(triangle))
            ++_gaps;
        else
            extendStrip(triangle);
    }
}

void LeafOrderMeter::extendStrip(const LeafTriangle& triangle)
{
    ++_triangles;
    if (continuesStrip(triangle)) return;
    ++_strips;
    _stripVertices += 3;
    _strip = {triangle.vertices[0], triangle.vertices[1], triangle.vertices[2], 1};
}

bool LeafOrderMeter::continuesStrip(const LeafTriangle& triangle)
{
    Strip& s = _strip;
    if (s.length == 0) return false;
    if (s.length == 1)
    { // any edge will do; its vertices' order shows with the triangle after the next
        const std::uint32_t corners[3] = {s.older, s.newer, s.newest};
        for (int missing = 0; missing < 3; ++missing)
            if (!has(triangle, corners[missing]))
            {
                s.older = corners[(missing + 1) % 3];
                s.newer = corners[(missing + 2) % 3];
            }
    }
    else if (has(triangle, s.newest) && has(triangle, s.newer))
        s.older = std::exchange(s.newer, s.newest);
    else if (has(triangle, s.newest) && has(triangle, s.older))
    {
        if (s.length > 2) ++_stripVertices;
        s.newer = s.newest;
    }
    else
        return false;
    if (!has(triangle, s.older) || !has(triangle, s.newer)) return false;
    s.newest = thirdCorner(triangle, s.older, s.newer);
    ++s.length;
    ++_stripVertices;
    return true;
}

namespace
{

/// All patches are alike, each drawn by a call of its own.
LeafOrder orderOf(const PatchShape& shape)
{
    LeafOrderMeter meter(static_cast<std::uint32_t>(shape.vertices.size()));
    std::vector<LeafTriangle> drawn;
    for (const PatchShape::Triangle& t : shape.triangles)
        drawn.push_back({{t[0], t[1], t[2]}});
    meter.draw(drawn);
    return meter.result();
}

} // namespace

LeafOrder orderOf(const TerrainMesh& mesh)
{
    if (mesh.patches()) return orderOf(mesh.patches()->shape());
    LeafOrderMeter meter(mesh.vertexSlots());
    std::vector<LeafTriangle> drawn;
    for (const IndexRange& range : mesh.allRanges())
    {
        drawn.clear();
        mesh.appendTriangles(range, drawn);
        meter.draw(drawn);
    }
    return meter.result();
}

LeafOrder orderOf(const DrawnMesh& mesh)
{
    LeafOrderMeter meter(static_cast<std::uint32_t>(mesh.vertices.size()));
    meter.draw(mesh.triangles);
    return meter.result();
}

LeafOrder LeafOrderMeter::result() const
{
    if (_triangles == 0) return {};
    const auto per = [](std::uint64_t sum, std::uint64_t count)
    { return static_cast<double>(sum) / static_cast<double>(count); };
    return {per(_triangles, _strips),           per(_stripVertices, _triangles),
            per(_fifo16.misses(), _triangles),  per(_fifo32.misses(), _triangles),
            per(_batch32.misses(), _triangles), per(_gaps, _triangles)};
}

} // namespace osgTerrainROAM::core
