// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace testsupport
{

/// What became of rays from an eye above the ground.
struct RayFindings
{
    std::size_t deep = 0;      ///< rays that go into the ground, deeper than the drawn surface may be off
    std::size_t missed = 0;    ///< those of them that met no triangle
    std::size_t fromBelow = 0; ///< those that met a triangle from its lower side first
};

/// Casts rays against all triangles of a mesh, by brute force. Precondition: the tile lies on a plane.
class RayCheck
{
public:
    RayCheck(const osgTerrainROAM::core::RoamTile& tile, const osgTerrainROAM::core::DrawnMesh& mesh,
             const viewlod::ViewState& view, double errorPx)
        : _tile(tile.tile), _view(view), _errorPx(errorPx), _corner(_tile.position(0, 0))
    {
        for (const osgTerrainROAM::core::LeafTriangle& t : mesh.triangles)
            _triangles.push_back({mesh.position(t.vertices[0]),
                                  mesh.position(t.vertices[1]) - mesh.position(t.vertices[0]),
                                  mesh.position(t.vertices[2]) - mesh.position(t.vertices[0])});
    }

    /// Casts a ray from the eye through a point.
    void cast(const glm::dvec3& through)
    {
        const glm::dvec3 direction = glm::normalize(through - _view.eyeWorld);
        if (!goesDeep(direction)) return;
        ++findings.deep;
        double nearestM = std::numeric_limits<double>::infinity();
        bool isFromBelow = false;
        for (const Triangle& t : _triangles)
            if (const auto distanceM = meet(t, direction); distanceM && *distanceM < nearestM)
            {
                nearestM = *distanceM;
                isFromBelow = glm::dot(glm::cross(t.u, t.w), direction) > 0.0;
            }
        findings.missed += std::isinf(nearestM) ? 1 : 0;
        findings.fromBelow += isFromBelow ? 1 : 0;
    }

    RayFindings findings;

private:
    struct Triangle
    {
        glm::dvec3 corner, u, w;
    };

    /// Möller and Trumbore, *Fast, minimum storage ray-triangle intersection*, 1997. A ray through an edge
    /// meets both triangles.
    std::optional<double> meet(const Triangle& t, const glm::dvec3& direction) const
    {
        constexpr double kEdge = 1e-9;
        const glm::dvec3 p = glm::cross(direction, t.w);
        const double determinant = glm::dot(t.u, p);
        if (determinant == 0.0) return std::nullopt;
        const glm::dvec3 from = _view.eyeWorld - t.corner;
        const double a = glm::dot(from, p) / determinant;
        const glm::dvec3 q = glm::cross(from, t.u);
        const double b = glm::dot(direction, q) / determinant, distanceM = glm::dot(t.w, q) / determinant;
        if (a < -kEdge || b < -kEdge || a + b > 1.0 + kEdge || distanceM < 0.0) return std::nullopt;
        return distanceM;
    }

    /// Walks along the ray, a quarter of a cell at a time, until it is lower than the drawn surface can be.
    bool goesDeep(const glm::dvec3& direction) const
    {
        const auto& field = _tile.field();
        const double cellM = std::min(field.spacingEastM, field.spacingNorthM),
                     stepM = 0.25 * cellM / std::max(glm::length(glm::dvec2(direction)), 1e-3);
        const int columns = _tile.grid().dataColumns(), rows = _tile.grid().dataRows();
        for (double distanceM = 0.0; distanceM < 4.0 * cellM * (columns + rows); distanceM += stepM)
        {
            const glm::dvec3 at = _view.eyeWorld + distanceM * direction;
            const double column = (at.x - _corner.x) / field.spacingEastM,
                         row = (at.y - _corner.y) / field.spacingNorthM;
            if (!(column >= 0.0 && row >= 0.0 && column < columns - 1 && row < rows - 1)) continue;
            const int c = static_cast<int>(column), r = static_cast<int>(row);
            const double lowestM = std::min({_tile.position(c, r).z, _tile.position(c + 1, r).z,
                                             _tile.position(c, r + 1).z, _tile.position(c + 1, r + 1).z});
            const double offM = _errorPx * std::max(distanceM, _view.nearM) / _view.pixelsPerTangent;
            if (at.z < lowestM - 2.0 * offM) return true;
        }
        return false;
    }

    const osgTerrainROAM::core::PlacedTile& _tile;
    const viewlod::ViewState& _view;
    double _errorPx;
    glm::dvec3 _corner;
    std::vector<Triangle> _triangles;
};

} // namespace testsupport
