// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <osgPMObjects/core/consolidate/Normals.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/UnionFind.h>
#include <osgPMObjects/core/mesh/Wedge.h>

#include "../mesh/UnitVector.h"

namespace osgPMObjects::core
{

namespace
{

class Smoother
{
public:
    Smoother(Mesh& mesh, const Smoothing& smoothing)
        : _mesh(mesh),
          _smoothing(smoothing),
          _triangles(positionTriangles(mesh)),
          _edges(_triangles, mesh.positions.size()),
          _corners(3 * _triangles.size())
    {
        for (const Triangle& t : _triangles)
            _normals.push_back(unitOr0(glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]))));
    }

    std::size_t run()
    {
        joinSmoothEdges();
        std::vector<glm::dvec3> sums(3 * _triangles.size(), glm::dvec3(0.0)); // by root corner
        for (HalfEdge corner = 0; corner < sums.size(); ++corner)
            sums[_corners.root(corner)] += angleAt(corner) * _normals[faceOf(corner)];
        std::size_t given = 0;
        for (std::uint32_t f = 0; f < _triangles.size(); ++f)
        {
            if (!isWanted(f)) continue;
            ++given;
            for (HalfEdge corner = 3 * f; corner < 3 * f + 3; ++corner)
                give(corner, sums[_corners.root(corner)]);
        }
        for (const std::uint32_t material : _newlyLit)
            _mesh.materials[material].attributes |= Material::normal;
        return given;
    }

private:
    const glm::dvec3& at(std::uint32_t position) const { return _mesh.positions[position]; }

    void joinSmoothEdges()
    {
        const double leastCosine = std::cos(glm::radians(_smoothing.creaseAngleDeg));
        for (std::uint32_t e = 0; e < _edges.size(); ++e)
        {
            const auto sides = _edges.sides(e);
            if (sides.size() != 2 || endsOf(_triangles, sides[0]) == endsOf(_triangles, sides[1])) continue;
            if (!isSmooth(faceOf(sides[0]), faceOf(sides[1]), leastCosine)) continue;
            _corners.join(sides[0], nextSide(sides[1]));
            _corners.join(nextSide(sides[0]), sides[1]);
        }
    }

    bool isSmooth(std::uint32_t a, std::uint32_t b, double leastCosine) const
    {
        if (!_smoothing.groups.empty()) return (_smoothing.groups[a] & _smoothing.groups[b]) != 0;
        return glm::dot(_normals[a], _normals[b]) >= leastCosine;
    }

    double angleAt(HalfEdge corner) const
    {
        const Triangle& t = _triangles[faceOf(corner)];
        const glm::dvec3& here = at(t[cornerOf(corner)]);
        const glm::dvec3 a = unitOr0(at(t[cornerOf(nextSide(corner))]) - here);
        const glm::dvec3 b = unitOr0(at(t[cornerOf(previousSide(corner))]) - here);
        return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
    }

    bool isWanted(std::uint32_t f) const
    {
        if (!_smoothing.onlyMissing) return true;
        const Face& face = _mesh.faces[f];
        const Material& material = _mesh.materials[face.material];
        if ((material.unseen & Material::normal) != 0) return false;
        return !material.has(Material::normal) || _mesh.normals.empty() ||
               std::any_of(face.wedges.begin(), face.wedges.end(),
                           [&](std::uint32_t w) { return _mesh.normals[w] == glm::vec3(0.0f); });
    }

    void give(HalfEdge corner, const glm::dvec3& sum)
    {
        Face& face = _mesh.faces[faceOf(corner)];
        std::uint32_t& wedge = face.wedges[cornerOf(corner)];
        const auto [known, isNew] = _given.try_emplace({wedge, _corners.root(corner)}, 0);
        if (isNew)
        {
            Wedge made = wedgeOf(_mesh, wedge);
            const glm::dvec3 mean = unitOr0(sum); // 0 where the faces cancel out
            made.normal = glm::vec3(mean == glm::dvec3(0.0) ? _normals[faceOf(corner)] : mean);
            known->second = appendWedge(_mesh, made);
        }
        wedge = known->second;
        if (!_mesh.materials[face.material].has(Material::normal)) _newlyLit.push_back(face.material);
    }

    Mesh& _mesh;
    const Smoothing& _smoothing;
    const std::vector<Triangle> _triangles;
    const EdgeTable _edges;
    UnionFind _corners;               ///< sets with one normal
    std::vector<glm::dvec3> _normals; ///< by face
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>
        _given; ///< (wedge, corner group) → new wedge
    std::vector<std::uint32_t> _newlyLit;
};

} // namespace

std::size_t computeNormals(Mesh& mesh, const Smoothing& smoothing)
{
    return Smoother(mesh, smoothing).run();
}

} // namespace osgPMObjects::core
