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

/// The least cosine between a new face and the plane that fits the contour: steeper faces fold the surface in
/// most views.
constexpr double kLeastUpCosine = 0.1;

/// Smaller coordinates are rounding errors of the projection, and out of range for orientation().
constexpr double kNoise = 0x1p-100;

/// Rounds a projected coordinate of a contour of size 1.
double coordinate(double x)
{
    return std::abs(x) < kNoise ? 0.0 : x;
}

} // namespace

RemovalRefusal HoleFilling::fill(const VertexStar& star, HoleTriangulation triangulation)
{
    if (triangulation == HoleTriangulation::fan) return fillByFan(star);
    _apex = RemovalStep::kNoApex;
    return addFan(star, _apex) ? fitness(star) : RemovalRefusal::folds;
}

/// Tries the fans that fold nothing, the best first.
RemovalRefusal HoleFilling::fillByFan(const VertexStar& star)
{
    findFans(star);
    RemovalRefusal refusal = RemovalRefusal::folds;
    for (const Fan& fan : _fans)
    {
        _apex = fan.apex;
        addFan(star, fan.apex);
        refusal = fitness(star);
        if (refusal == RemovalRefusal::none) break;
    }
    return refusal;
}

/// Tells whether the new faces fit among the others.
RemovalRefusal HoleFilling::fitness(const VertexStar& star)
{
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

/// Finds the positions from which all contours can be filled. A contour that one more edge closes is filled
/// from an end of that edge, for only so the removal is a collapse of an edge.
void HoleFilling::findFans(const VertexStar& star)
{
    _fans.clear();
    takeContour(star, star.sectors.front());
    std::vector<std::uint32_t> apexes = _positions;
    if (!star.sectors.front().isClosed) apexes = {_positions.front(), _positions.back()};
    for (const std::uint32_t apex : apexes)
        if (addFan(star, apex)) _fans.push_back({leastAngleCosine(), apex});
    std::sort(_fans.begin(), _fans.end());
}

/// Makes the new faces of all sectors. False: one folds over, or a contour does not have the apex.
bool HoleFilling::addFan(const VertexStar& star, std::uint32_t apex)
{
    _faces.clear();
    return std::all_of(star.sectors.begin(), star.sectors.end(),
                       [&](const StarSector& sector) { return fillSector(star, sector, apex); });
}

/// Returns the cosine of the least angle of the new faces; -1 where there are none.
double HoleFilling::leastAngleCosine() const
{
    double most = -1.0;
    for (const Face& face : _faces)
        for (int c = 0; c < 3; ++c)
        {
            const glm::dvec3& at = _live.mesh().at(face, c);
            const glm::dvec3 a = _live.mesh().at(face, (c + 1) % 3) - at,
                             b = _live.mesh().at(face, (c + 2) % 3) - at;
            most = std::max(most, glm::dot(a, b) / (glm::length(a) * glm::length(b)));
        }
    return most;
}

void HoleFilling::takeContour(const VertexStar& star, const StarSector& sector)
{
    _positions.clear();
    _wedges.clear();
    for (std::uint32_t i = sector.first; i < sector.first + sector.count; ++i)
    {
        _positions.push_back(star.faces[i].from);
        _wedges.push_back(star.faces[i].fromWedge);
    }
    if (!sector.isClosed)
    {
        _positions.push_back(star.faces[sector.first + sector.count - 1].to);
        _wedges.push_back(star.faces[sector.first + sector.count - 1].toWedge);
    }
    _contour.clear();
    for (const std::uint32_t position : _positions)
        _contour.push_back(_live.at(position));
}

/// Projects the contour into the plane across its average normal, scaled to size 1. False: it has none, or
/// the opposite orientation of the faces that it replaces.
bool HoleFilling::project(const glm::dvec3& sectorNormal)
{
    const glm::dvec3 normal = areaVector(_contour);
    const double size = extentOf(_contour).diagonal(), area = glm::length(normal);
    if (!(area > kContourFlatness * size * size) || !(glm::dot(normal, sectorNormal) > 0.0)) return false;
    _up = normal / area;
    const glm::dvec3 across = std::abs(_up.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(across, _up)), y = glm::cross(_up, x);
    _flat.clear();
    for (const glm::dvec3& p : _contour)
    {
        const glm::dvec3 from = (p - _contour[0]) / size;
        _flat.emplace_back(coordinate(glm::dot(from, x)), coordinate(glm::dot(from, y)));
    }
    return true;
}

/// Triangulates the projected contour; with an apex, by triangles that all have it.
bool HoleFilling::triangulate(std::uint32_t apex)
{
    _triangles.clear();
    if (apex == RemovalStep::kNoApex) return triangulateContour(_flat, _triangles);
    const auto found = std::find(_positions.begin(), _positions.end(), apex);
    if (found == _positions.end() || !isSimpleContour(_flat)) return false;
    const auto size = static_cast<std::uint32_t>(_positions.size());
    const auto first = static_cast<std::uint32_t>(found - _positions.begin());
    for (std::uint32_t i = 1; i + 1 < size; ++i)
        _triangles.push_back({first, (first + i) % size, (first + i + 1) % size});
    return true;
}

bool HoleFilling::liesFlat(const Triangle& t, const glm::dvec3& sectorNormal) const
{
    const glm::dvec3 own = glm::cross(_contour[t[1]] - _contour[t[0]], _contour[t[2]] - _contour[t[0]]);
    return glm::dot(own, _up) >= kLeastUpCosine * glm::length(own) && glm::dot(own, sectorNormal) > 0.0;
}

bool HoleFilling::fillSector(const VertexStar& star, const StarSector& sector, std::uint32_t apex)
{
    takeContour(star, sector);
    const bool isAtEnd = apex == RemovalStep::kNoApex || sector.isClosed || apex == _positions.front() ||
                         apex == _positions.back();
    if (!isAtEnd) return false;
    if (_wedges.size() < 3)
        return apex == RemovalStep::kNoApex || star.sectors.size() == 1 || !sector.isClosed;
    glm::dvec3 normal(0.0);
    for (std::uint32_t i = sector.first; i < sector.first + sector.count; ++i)
        normal += star.faces[i].area;
    if (!project(normal) || !triangulate(apex)) return false;
    if (!std::all_of(_triangles.begin(), _triangles.end(),
                     [&](const Triangle& t) { return liesFlat(t, normal); }))
        return false;
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

/// Whether an edge would have two faces of the same direction, or a face would exist twice, in either
/// orientation. Only sides that the star did not have can be new, and faces with sides of the star only.
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

/// Whether a direction of the first side of an added face has more than one face, or the face exists already.
/// `along`, `against`: number of added faces on the side in each direction.
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
