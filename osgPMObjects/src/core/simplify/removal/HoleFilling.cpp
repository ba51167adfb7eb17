// SPDX-License-Identifier: Apache-2.0
#include "HoleFilling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>
#include <osgPMObjects/core/simplify/ContourTriangulation.h>
#include <osgPMObjects/core/tessellate/PolygonProjection.h>

namespace osgPMObjects::core
{

namespace
{

/// The least cosine between a new face and the plane that fits the contour: steeper faces fold the surface in most views.
constexpr double kLeastUpCosine = 0.1;

/// Smaller coordinates are rounding errors of the projection, and out of range for orientation().
constexpr double kNoise = 0x1p-100;

/// Rounds a projected coordinate of a contour of size 1.
double coordinate(double x)
{
    return std::abs(x) < kNoise ? 0.0 : x;
}

} // namespace

RemovalRefusal HoleFilling::fill(const VertexStar& star)
{
    _faces.clear();
    for (const StarSector& sector : star.sectors)
        if (!fillSector(star, sector)) return RemovalRefusal::folds;
    _corners.clear();
    for (const Face& face : _faces)
        _corners.push_back({_live.mesh().positionOf(face, 0), _live.mesh().positionOf(face, 1),
                            _live.mesh().positionOf(face, 2)});
    if (joins(star)) return RemovalRefusal::joins;
    if (isolates(star)) return RemovalRefusal::isolates;
    if (endsMaterial(star)) return RemovalRefusal::lastOfMaterial;
    measure(star);
    return RemovalRefusal::none;
}

void HoleFilling::takeContour(const VertexStar& star, const StarSector& sector)
{
    _wedges.clear();
    _contour.clear();
    for (std::uint32_t i = sector.first; i < sector.first + sector.count; ++i)
    {
        _wedges.push_back(star.faces[i].fromWedge);
        _contour.push_back(_live.at(star.faces[i].from));
    }
    if (sector.isClosed) return;
    _wedges.push_back(star.faces[sector.first + sector.count - 1].toWedge);
    _contour.push_back(_live.at(star.faces[sector.first + sector.count - 1].to));
}

/// Projects the contour into the plane across its average normal, scaled to size 1. False: it has none, or the opposite orientation
/// of the faces that it replaces.
bool HoleFilling::project(const glm::dvec3& sectorNormal)
{
    const glm::dvec3 normal = areaVector(_contour);
    const double size = extentOf(_contour).diagonal(), area = glm::length(normal);
    if (!(area > kContourFlatness * size * size) || !(glm::dot(normal, sectorNormal) > 0.0)) return false;
    const glm::dvec3 up = normal / area;
    const glm::dvec3 across = std::abs(up.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(across, up)), y = glm::cross(up, x);
    _flat.clear();
    for (const glm::dvec3& p : _contour)
    {
        const glm::dvec3 from = (p - _contour[0]) / size;
        _flat.emplace_back(coordinate(glm::dot(from, x)), coordinate(glm::dot(from, y)));
    }
    _triangles.clear();
    if (!triangulateContour(_flat, _triangles)) return false;
    return std::all_of(_triangles.begin(), _triangles.end(),
                       [&](const Triangle& t)
                       {
                           const glm::dvec3 own =
                               glm::cross(_contour[t[1]] - _contour[t[0]], _contour[t[2]] - _contour[t[0]]);
                           return glm::dot(own, up) >= kLeastUpCosine * glm::length(own) &&
                                  glm::dot(own, sectorNormal) > 0.0;
                       });
}

bool HoleFilling::fillSector(const VertexStar& star, const StarSector& sector)
{
    takeContour(star, sector);
    if (_wedges.size() < 3) return true; // two sides that coincide
    glm::dvec3 normal(0.0);
    for (std::uint32_t i = sector.first; i < sector.first + sector.count; ++i)
        normal += star.faces[i].area;
    if (!project(normal)) return false;
    const Face& like = _live.face(star.faces[sector.first].slot);
    for (const Triangle& t : _triangles)
        _faces.push_back({{_wedges[t[0]], _wedges[t[1]], _wedges[t[2]]}, like.material, like.part});
    return true;
}

std::size_t HoleFilling::addedSides(std::uint32_t from, std::uint32_t to) const
{
    std::size_t count = 0;
    for (const Triangle& t : _corners)
        for (int c = 0; c < 3; ++c)
            count += t[c] == from && t[(c + 1) % 3] == to ? 1u : 0u;
    return count;
}

/// Whether an edge would have two faces of the same direction, or a face would exist twice, in either orientation. Only sides
/// that the star did not have can be new, and faces with sides of the star only.
bool HoleFilling::joins(const VertexStar& star) const
{
    const auto isStars = [&](std::uint32_t from, std::uint32_t to)
    {
        return std::any_of(star.faces.begin(), star.faces.end(),
                           [&](const StarFace& f) { return f.from == from && f.to == to; });
    };
    for (const Triangle& added : _corners)
    {
        const bool isAllStars =
            isStars(added[0], added[1]) && isStars(added[1], added[2]) && isStars(added[2], added[0]);
        for (int c = 0; c < 3; ++c)
        {
            const std::uint32_t from = added[c], to = added[(c + 1) % 3];
            const std::size_t along = addedSides(from, to), against = addedSides(to, from);
            if (along > 1) return true;
            if (!isAllStars && (isStars(from, to) || (against > 0 && to < from))) continue;
            if (isTaken(star.position, {from, to, added[(c + 2) % 3]}, along, against)) return true;
        }
    }
    return false;
}

/// Whether a direction of the first side of an added face has more than one face, or the face exists already. `along`, `against`:
/// number of added faces on the side in each direction.
bool HoleFilling::isTaken(std::uint32_t removed, const Triangle& added, std::size_t along,
                          std::size_t against) const
{
    const std::uint32_t from = added[0], to = added[1], third = added[2];
    bool isCopied = false;
    _live.visit(from,
                [&](std::uint32_t slot, int corner)
                {
                    const Triangle& t = _live.triangle(slot);
                    if (t[0] == removed || t[1] == removed || t[2] == removed) return;
                    const std::uint32_t next = t[(corner + 1) % 3], last = t[(corner + 2) % 3];
                    along += next == to ? 1u : 0u;
                    against += last == to ? 1u : 0u;
                    isCopied = isCopied || (next == to && last == third) || (next == third && last == to);
                });
    return along > 1 || against > 1 || isCopied;
}

bool HoleFilling::isolates(const VertexStar& star) const
{
    const auto uses = [](const Triangle& t, std::uint32_t p) { return t[0] == p || t[1] == p || t[2] == p; };
    const auto isLeftAlone = [&](std::uint32_t p)
    {
        const auto ofStar = std::count_if(star.faces.begin(), star.faces.end(),
                                          [&](const StarFace& f) { return f.from == p || f.to == p; });
        return _live.degree(p) == static_cast<std::uint32_t>(ofStar) &&
               std::none_of(_corners.begin(), _corners.end(), [&](const auto& t) { return uses(t, p); });
    };
    return std::any_of(star.faces.begin(), star.faces.end(),
                       [&](const StarFace& f) { return isLeftAlone(f.from) || isLeftAlone(f.to); });
}

bool HoleFilling::endsMaterial(const VertexStar& star) const
{
    const auto isLast = [&](std::uint32_t material)
    {
        const auto ofStar =
            std::count_if(star.faces.begin(), star.faces.end(),
                          [&](const StarFace& f) { return _live.face(f.slot).material == material; });
        return _live.facesOf(material) == static_cast<std::size_t>(ofStar) &&
               std::none_of(_faces.begin(), _faces.end(),
                            [&](const Face& f) { return f.material == material; });
    };
    return std::any_of(star.faces.begin(), star.faces.end(),
                       [&](const StarFace& f) { return isLast(_live.face(f.slot).material); });
}

void HoleFilling::measure(const VertexStar& star)
{
    const glm::dvec3& p = _live.at(star.position);
    _distance = _corners.empty() ? star.distance : std::numeric_limits<double>::infinity();
    for (const Triangle& t : _corners)
        _distance = std::min(
            _distance, glm::length(p - nearestPoint(p, _live.at(t[0]), _live.at(t[1]), _live.at(t[2]))));
}

} // namespace osgPMObjects::core
