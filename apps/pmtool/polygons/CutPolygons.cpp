// SPDX-License-Identifier: Apache-2.0
#include "pmtool/polygons/CutPolygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include <osgPMObjects/core/tessellate/Tessellation.h>
#include <osgPMObjects/core/tessellate/UniformMesh.h>
#include <osgPMObjects/core/tessellate/WarpedQuad.h>

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using foundation::Outcome;

/// Cuts one polygon after the other into a mesh.
class PolygonCutter
{
public:
    PolygonCutter(const PolygonSet& set, const CutSettings& settings) : _settings(settings)
    {
        _mesh.positions = set.positions;
        _mesh.texCoords = set.texCoords;
    }

    Outcome cut(const Polygon& polygon)
    {
        CutCounts& counts = _mesh.counts;
        ++counts.polygons;
        counts.corners += polygon.corners.size();
        counts.holes += polygon.contourSizes.size() - 1;
        const bool isTexturedQuad = polygon.isTextured && polygon.corners.size() == 4;
        if (isTexturedQuad && _settings.warpTolerance > 0.0 && cutToGrid(polygon))
            return foundation::success();
        if (isTexturedQuad && _settings.quadTexture != QuadTexture::affine && cutAlongDiagonal(polygon))
            return foundation::success();
        std::vector<glm::dvec3> corners;
        for (const std::uint32_t vertex : polygon.corners)
            corners.push_back(_mesh.positions[vertex]);
        return _settings.isConvex ? cutConvex(polygon, corners) : cutToTriangles(polygon, corners);
    }

    /// Halves long edges of all triangles.
    Outcome refine()
    {
        if (_settings.longestEdge <= 0.0) return foundation::success();
        std::vector<core::Triangle> triangles;
        for (const auto& face : _mesh.faces)
            triangles.push_back({face[0], face[1], face[2]});
        auto fine = core::meshUniformly(_mesh.positions, triangles, _settings.longestEdge);
        if (!fine) return fine.error();
        _mesh.positions = std::move(fine->positions);
        if (!_mesh.texCoords.empty())
            for (const auto& [a, b] : fine->midpointOf)
                _mesh.texCoords.push_back(0.5 * (_mesh.texCoords[a] + _mesh.texCoords[b]));
        _mesh.faces.clear();
        for (const core::Triangle& t : fine->triangles)
            _mesh.faces.push_back({t[0], t[1], t[2]});
        return foundation::success();
    }

    CutMesh finish() { return std::move(_mesh); }

private:
    Outcome cutToTriangles(const Polygon& polygon, const std::vector<glm::dvec3>& corners)
    {
        const auto cut = core::tessellate(corners, polygon.contourSizes, _settings.outline);
        if (!cut) return cut.error();
        const auto vertices = verticesOf(polygon, corners, cut->inserted);
        for (const core::Triangle& t : cut->triangles)
        {
            _mesh.faces.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
            if (polygon.isTextured && _settings.quadTexture == QuadTexture::preWarped)
                addTexturedFace(_mesh.faces.back(), polygon.location);
        }
        _mesh.counts.crossings += cut->crossings;
        _mesh.counts.unusedCorners += cut->unusedCorners;
        _mesh.counts.bridges += cut->bridges;
        return foundation::success();
    }

    Outcome cutConvex(const Polygon& polygon, const std::vector<glm::dvec3>& corners)
    {
        const auto cut =
            core::decomposeConvex(corners, polygon.contourSizes, _settings.convexMethod, _settings.outline);
        if (!cut) return cut.error();
        const auto vertices = verticesOf(polygon, corners, cut->inserted);
        for (const core::Loop& piece : cut->pieces)
        {
            auto& face = _mesh.faces.emplace_back();
            for (const std::uint32_t corner : piece)
                face.push_back(vertices[corner]);
        }
        _mesh.counts.leastPieces += cut->isLeast;
        return foundation::success();
    }

    /// A textured polygon of three or four vertices; of three the fourth corner is 0.
    core::TexturedQuad quadOf(const std::vector<std::uint32_t>& corners) const
    {
        core::TexturedQuad quad{};
        for (std::size_t i = 0; i < corners.size(); ++i)
        {
            quad.positions[i] = _mesh.positions[corners[i]];
            quad.texCoords[i] = _mesh.texCoords[corners[i]];
        }
        return quad;
    }

    void addTexturedFace(const std::vector<std::uint32_t>& corners, const std::string& location)
    {
        _mesh.texturedFaces.push_back({quadOf(corners), corners.size() == 4, location});
    }

    /// Returns false where the quad is not convex.
    bool cutAlongDiagonal(const Polygon& polygon)
    {
        const core::TexturedQuad quad = quadOf(polygon.corners);
        const auto coords = core::projectiveTexCoords(quad);
        ++(coords ? _mesh.counts.warpedQuads : _mesh.counts.refusedQuads);
        if (!coords) return false;
        std::vector<std::uint32_t> vertices = polygon.corners;
        if (_settings.quadTexture == QuadTexture::preWarped)
            addTexturedFace(polygon.corners, polygon.location);
        else if (!isEvenlyDivided(*coords))
            for (std::size_t i = 0; i < 4; ++i)
                vertices[i] = addVertex(quad.positions[i], glm::dvec2((*coords)[i]), (*coords)[i].z);
        _mesh.faces.push_back({vertices[0], vertices[1], vertices[2]});
        _mesh.faces.push_back({vertices[0], vertices[2], vertices[3]});
        return true;
    }

    /// Whether an affine map does, as for a parallelogram.
    static bool isEvenlyDivided(const std::array<glm::dvec3, 4>& coords)
    {
        constexpr double kRounding = 1e-12;
        return std::all_of(coords.begin(), coords.end(),
                           [&](const glm::dvec3& c)
                           { return std::abs(c.z - coords[0].z) <= kRounding * coords[0].z; });
    }

    /// Returns false where the quad cannot be a grid within the tolerance.
    bool cutToGrid(const Polygon& polygon)
    {
        const auto grid = core::meshQuad(quadOf(polygon.corners), _settings.warpTolerance);
        ++(grid ? _mesh.counts.grids : _mesh.counts.refusedGrids);
        if (!grid) return false;
        // The grid's corners are the quad's own vertices, so that neighbours still meet there.
        const std::uint32_t n = grid->cells, last = n * (n + 2);
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t i = 0; i <= last; ++i)
            if (i == 0 || i == n || i == last || i == last - n)
                vertices.push_back(polygon.corners[i == 0 ? 0 : i == n ? 1 : i == last ? 2 : 3]);
            else
                vertices.push_back(addVertex(grid->positions[i], grid->texCoords[i]));
        for (const core::Triangle& t : grid->triangles)
            _mesh.faces.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
        return true;
    }

    /// The vertices of a polygon's corners, and new ones for its inserted points.
    std::vector<std::uint32_t> verticesOf(const Polygon& polygon, const std::vector<glm::dvec3>& corners,
                                          const std::vector<core::InsertedPoint>& inserted)
    {
        std::vector<std::uint32_t> vertices = polygon.corners;
        for (const core::InsertedPoint& point : inserted)
        {
            glm::dvec2 texCoord(0.0);
            for (std::size_t i = 0; i < 4 && !_mesh.texCoords.empty(); ++i)
                texCoord += point.weights[i] * _mesh.texCoords[polygon.corners[point.corners[i]]];
            vertices.push_back(addVertex(core::positionOf(point, corners), texCoord));
        }
        _mesh.counts.inserted += inserted.size();
        return vertices;
    }

    std::uint32_t addVertex(const glm::dvec3& position, const glm::dvec2& texCoord, double divisor = 1.0)
    {
        if (_mesh.texDivisors.empty() && divisor != 1.0)
            _mesh.texDivisors.resize(_mesh.positions.size(), 1.0);
        _mesh.positions.push_back(position);
        if (!_mesh.texCoords.empty()) _mesh.texCoords.push_back(texCoord);
        if (!_mesh.texDivisors.empty()) _mesh.texDivisors.push_back(divisor);
        return static_cast<std::uint32_t>(_mesh.positions.size() - 1);
    }

    const CutSettings& _settings;
    CutMesh _mesh;
};

template<class... Values>
void addFormatted(std::string& text, const char* format, Values... values)
{
    char part[128];
    const int length = std::snprintf(part, sizeof part, format, values...);
    text.append(part, static_cast<std::size_t>(length));
}

} // namespace

foundation::Result<CutMesh> cutPolygons(const PolygonSet& set, const CutSettings& settings,
                                        const std::string& file)
{
    PolygonCutter cutter(set, settings);
    for (const Polygon& polygon : set.polygons)
        if (const auto done = cutter.cut(polygon); !done)
            return foundation::Error{file + ", " + polygon.location, done.error().what, done.error().remedy};
    if (const auto done = cutter.refine(); !done)
        return foundation::Error{file, done.error().what, done.error().remedy};
    return cutter.finish();
}

std::string objTextOf(const CutMesh& mesh)
{
    std::string text;
    for (const glm::dvec3& p : mesh.positions)
        addFormatted(text, "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
    for (std::size_t v = 0; v < mesh.texCoords.size(); ++v)
        if (const glm::dvec2& t = mesh.texCoords[v]; mesh.texDivisors.empty())
            addFormatted(text, "vt %.17g %.17g\n", t.x, t.y);
        else
            addFormatted(text, "vt %.17g %.17g %.17g\n", t.x, t.y, mesh.texDivisors[v]);
    for (const auto& face : mesh.faces)
    {
        text += 'f';
        for (const std::uint32_t vertex : face)
            if (mesh.texCoords.empty())
                addFormatted(text, " %u", vertex + 1);
            else
                addFormatted(text, " %u/%u", vertex + 1, vertex + 1);
        text += '\n';
    }
    return text;
}

} // namespace pmtool
