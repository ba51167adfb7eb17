// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/consolidate/SplitEdges.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/UnionFind.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

/// The most faces of an edge that are compared pair by pair; more are paired in their order, to limit the
/// time.
constexpr std::size_t kMostCompared = 64;

class Splitter
{
public:
    explicit Splitter(Mesh& mesh)
        : _mesh(mesh),
          _triangles(positionTriangles(mesh)),
          _edges(_triangles, mesh.positions.size()),
          _corners(3 * _triangles.size()),
          _isMarked(mesh.positions.size(), false)
    {
    }

    SplitEdges run()
    {
        for (std::uint32_t e = 0; e < _edges.size(); ++e)
            examine(_edges.sides(e));
        if (_report.crowded + _report.disagreeing > 0) separate();
        return _report;
    }

    /// Separates pairs of faces that are still together on an edge, since they are connected around both its
    /// ends: each pair after the first gets both ends for itself, which opens the other edges of its faces.
    std::size_t cutLoose()
    {
        for (std::uint32_t e = 0; e < _edges.size(); ++e)
        {
            const auto sides = _edges.sides(e);
            if (sides.size() == 1 || (sides.size() == 2 && agree(sides[0], sides[1]))) continue;
            for (std::size_t i = 1; i < sides.size(); ++i)
                for (const HalfEdge corner : {sides[i], nextSide(sides[i])})
                    if (positionNow(corner) == _triangles[faceOf(corner)][cornerOf(corner)])
                        moveTo(corner, copyOf(positionNow(corner)));
        }
        return _report.copies;
    }

private:
    void examine(std::span<const HalfEdge> sides)
    {
        if (sides.size() == 1) return;
        if (sides.size() == 2 && agree(sides[0], sides[1])) return join(sides[0], sides[1]);
        ++(sides.size() == 2 ? _report.disagreeing : _report.crowded);
        const auto [from, to] = endsOf(_triangles, sides[0]);
        _isMarked[from] = _isMarked[to] = true;
        pair(sides);
    }

    bool agree(HalfEdge a, HalfEdge b) const { return endsOf(_triangles, a) != endsOf(_triangles, b); }

    /// Joins two corners; a corner has the number of the side that begins at it.
    void join(HalfEdge a, HalfEdge b)
    {
        _corners.join(a, nextSide(b));
        _corners.join(nextSide(a), b);
    }

    void pair(std::span<const HalfEdge> sides)
    {
        using Candidate =
            std::tuple<bool, bool, double, std::size_t, std::size_t>; // by places in `sides`, worst last
        std::vector<Candidate> candidates;
        const std::size_t reach = sides.size() <= kMostCompared ? sides.size() : 2;
        for (std::size_t i = 0; i < sides.size(); ++i)
            for (std::size_t j = i + 1; j < std::min(sides.size(), i + reach); ++j)
            {
                if (!agree(sides[i], sides[j])) continue;
                const Face &a = _mesh.faces[faceOf(sides[i])], &b = _mesh.faces[faceOf(sides[j])];
                candidates.emplace_back(a.part != b.part, a.material != b.material, fold(sides[i], sides[j]),
                                        i, j);
            }
        std::sort(candidates.begin(), candidates.end());
        std::vector<bool> isTaken(sides.size(), false);
        for (const auto& [otherPart, otherMaterial, fold, i, j] : candidates)
        {
            if (isTaken[i] || isTaken[j]) continue;
            join(sides[i], sides[j]);
            isTaken[i] = isTaken[j] = true;
        }
    }

    /// Returns -1 where two faces are coplanar across the edge, 1 where the second folds back onto the first.
    double fold(HalfEdge a, HalfEdge b) const { return glm::dot(inward(a), inward(b)); }

    /// Returns the direction from the edge into the face.
    glm::dvec3 inward(HalfEdge side) const
    {
        const auto [from, to] = endsOf(_triangles, side);
        const auto [low, high] = std::minmax(from, to);
        const glm::dvec3 along = glm::normalize(_mesh.positions[high] - _mesh.positions[low]);
        const glm::dvec3 in =
            _mesh.positions[_triangles[faceOf(side)][cornerOf(previousSide(side))]] - _mesh.positions[low];
        const glm::dvec3 across = in - glm::dot(in, along) * along;
        const double length = glm::length(across);
        return length > 0.0 ? across / length : across;
    }

    /// Gives separate corners at marked positions copies of the position.
    void separate()
    {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>
            positionOf; // (position, corner group) → position
        std::vector<bool> isGiven(_mesh.positions.size(), false);
        for (HalfEdge corner = 0; corner < 3 * _triangles.size(); ++corner)
        {
            const std::uint32_t p = _triangles[faceOf(corner)][cornerOf(corner)];
            if (!_isMarked[p]) continue;
            const auto [place, isNew] = positionOf.try_emplace({p, _corners.root(corner)}, p);
            if (isNew && isGiven[p]) place->second = copyOf(p);
            isGiven[p] = true;
            if (place->second == p) continue;
            moveTo(corner, place->second);
        }
    }

    std::uint32_t positionNow(HalfEdge corner) const
    {
        return _mesh.positionOf(_mesh.faces[faceOf(corner)], cornerOf(corner));
    }

    void moveTo(HalfEdge corner, std::uint32_t position)
    {
        std::uint32_t& wedge = _mesh.faces[faceOf(corner)].wedges[cornerOf(corner)];
        const auto [known, isNew] = _wedgeAt.try_emplace({wedge, position}, 0);
        if (isNew)
        {
            Wedge moved = wedgeOf(_mesh, wedge);
            moved.position = position;
            known->second = appendWedge(_mesh, moved);
        }
        wedge = known->second;
    }

    std::uint32_t copyOf(std::uint32_t p)
    {
        ++_report.copies;
        const glm::dvec3 where = _mesh.positions[p];
        _mesh.positions.push_back(where);
        return static_cast<std::uint32_t>(_mesh.positions.size() - 1);
    }

    Mesh& _mesh;
    const std::vector<Triangle> _triangles;
    const EdgeTable _edges;
    UnionFind _corners;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> _wedgeAt; ///< (wedge, position) → wedge
    std::vector<bool> _isMarked; ///< positions on edges that are split
    SplitEdges _report;
};

} // namespace

SplitEdges splitNonManifoldEdges(Mesh& mesh)
{
    SplitEdges report = Splitter(mesh).run();
    if (report.crowded + report.disagreeing > 0) report.copies += Splitter(mesh).cutLoose();
    return report;
}

} // namespace osgPMObjects::core
