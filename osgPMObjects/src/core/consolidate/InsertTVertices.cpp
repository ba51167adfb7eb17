// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/consolidate/InsertTVertices.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/TJunctions.h>

#include "FaceCutter.h"

namespace osgPMObjects::core
{

namespace
{

/// Share of the tolerance that positions may move; the rest is for rounding to floats. Positions of a knot,
/// nearer to each other than the tolerance, which patient passes do not bring to rest, may move farther to
/// merge.
constexpr double kMostDrift = 0.97, kMostKnotDrift = 4.0;

/// One pass: all changes are collected before the first is made.
class Pass
{
public:
    Pass(Mesh& mesh, TVertexState& state)
        : _mesh(mesh),
          _tolerance(state.tolerance),
          _thinHeight(state.thinHeight),
          _mostDrift(kMostDrift * state.tolerance),
          _mostStitchDrift((state.thinHeight > 0.0 ? kMostKnotDrift : kMostDrift) * state.tolerance),
          _mostNewFaces(state.mostNewFaces),
          _isAtLimit(state.isAtLimit),
          _homes(state.homes),
          _waiting(state.waiting),
          _triangles(positionTriangles(mesh)),
          _edges(_triangles, mesh.positions.size()),
          _found(takeFound(findTJunctions(mesh.positions, _triangles, _edges, state.tolerance,
                                          OpenEdges::notMatched, state.among)))
    {
        state.noteHomes(mesh.positions);
        _waiting.clear();
    }

    TVertices run()
    {
        if (_isCutShort) return _report;
        stitch();
        if (_report.stitched > 0)
        {
            putOff();
            return _report;
        }
        std::size_t newFaces = 0;
        for (const TJunction& t : _found)
            newFaces += _edges.sides(t.edge).size();
        if (newFaces > _mostNewFaces) _isAtLimit = true;
        if (newFaces > _mostNewFaces) return _report;
        for (const TJunction& t : _found)
            plan(t);
        for (const TJunction& t : _found)
            if (t.distance > 0.5 * _tolerance) moveHalfway(t);
        carryOut();
        _mostNewFaces -= _report.inserted;
        return _report;
    }

private:
    /// Notes whether the search was cut short, which counts as if it would add too many faces.
    std::vector<TJunction> takeFound(FoundTJunctions found)
    {
        _isCutShort = found.isCutShort;
        _isAtLimit = _isAtLimit || found.isCutShort;
        return std::move(found.all);
    }

    std::pair<std::uint32_t, std::uint32_t> endsOfEdge(std::uint32_t edge) const
    {
        const auto [from, to] = endsOf(_triangles, _edges.sides(edge).front());
        return std::minmax(from, to);
    }

    /// Returns how far a place may be from one of those in a box.
    static double mostDistance(const glm::dvec3& from, const Extent& box)
    {
        return glm::length(glm::max(glm::abs(from - box.low), glm::abs(box.high - from)));
    }

    /// Moves a position, unless it would then be too far from where it was.
    bool move(std::uint32_t position, const glm::dvec3& where)
    {
        if (mostDistance(where, _homes[position]) > _mostDrift) return false;
        _mesh.positions[position] = where;
        return true;
    }

    /// Moves two positions to their middle, unless one that has become either would then be too far from
    /// where it was.
    bool moveTogether(std::uint32_t one, std::uint32_t other)
    {
        const glm::dvec3 middle = 0.5 * (_mesh.positions[one] + _mesh.positions[other]);
        Extent homes = _homes[one];
        homes.add(_homes[other].low);
        homes.add(_homes[other].high);
        if (mostDistance(middle, homes) > _mostStitchDrift) return false;
        for (const std::uint32_t position : {one, other})
        {
            _homes[position] = homes;
            _mesh.positions[position] = middle;
        }
        return true;
    }

    void stitch()
    {
        std::unordered_map<std::uint32_t, std::uint32_t> joined; // position → the one that replaces it
        std::unordered_set<std::uint32_t> isTaken;
        for (const TJunction& t : _found)
        {
            const auto [low, high] = endsOfEdge(t.edge);
            const std::uint32_t end = t.along < 0.5 ? low : high;
            const glm::dvec3 a = _mesh.positions[end], b = _mesh.positions[t.vertex];
            if (glm::length(b - a) > 2.0 * _tolerance || isTaken.count(end) || isTaken.count(t.vertex))
                continue;
            if (!moveTogether(end, t.vertex)) continue;
            isTaken.insert({end, t.vertex});
            joined[std::max(end, t.vertex)] = std::min(end, t.vertex);
        }
        _report.stitched = joined.size();
        if (joined.empty()) return;
        for (std::uint32_t& position : _mesh.wedgePositions)
            if (const auto found = joined.find(position); found != joined.end()) position = found->second;
    }

    void putOff()
    {
        for (const TJunction& t : _found)
        {
            const auto [low, high] = endsOfEdge(t.edge);
            _waiting.insert(_waiting.end(), {low, high, t.vertex});
        }
    }

    bool isThin(std::uint32_t f) const
    {
        const auto& at = _mesh.positions;
        const Triangle& t = _triangles[f];
        return _thinHeight > 0.0 && heightOf(at[t[0]], at[t[1]], at[t[2]]) <= _thinHeight;
    }

    void plan(const TJunction& t)
    {
        for (const HalfEdge side : _edges.sides(t.edge))
        {
            const std::uint32_t f = faceOf(side);
            if (_triangles[f][cornerOf(previousSide(side))] == t.vertex || isThin(f))
            {
                _slivers.insert(f);
                continue;
            }
            const auto [from, to] = endsOf(_triangles, side);
            const float along = static_cast<float>(from < to ? t.along : 1.0 - t.along);
            CrowdedFace& crowded =
                _crowded.try_emplace(f, CrowdedFace{_mesh.faces[f].wedges, {}}).first->second;
            std::vector<OnSide>& crowd = crowded.onSide[static_cast<std::size_t>(cornerOf(side))];
            crowd.insert(from < to ? crowd.end() : crowd.begin(), {t.vertex, along});
        }
    }

    /// Each vertex is moved once, even if it is near several edges.
    void moveHalfway(const TJunction& t)
    {
        if (!_moved.insert(t.vertex).second) return;
        const auto [low, high] = endsOfEdge(t.edge);
        const glm::dvec3 foot = glm::mix(_mesh.positions[low], _mesh.positions[high], t.along);
        _report.moved += move(t.vertex, 0.5 * (_mesh.positions[t.vertex] + foot));
    }

    void carryOut()
    {
        if (_crowded.empty() && _slivers.empty()) return;
        EdgeWedges wedges(_mesh);
        std::vector<Face> faces;
        faces.reserve(_mesh.faces.size() + 2 * _crowded.size());
        for (std::uint32_t f = 0; f < _mesh.faces.size(); ++f)
        {
            if (_slivers.count(f)) continue;
            const auto crowded = _crowded.find(f);
            if (crowded == _crowded.end())
            {
                faces.push_back(_mesh.faces[f]);
                continue;
            }
            const std::size_t before = faces.size();
            cutFace(crowded->second, _mesh.faces[f], wedges, faces);
            _report.inserted += faces.size() - before - 1;
        }
        _mesh.faces = std::move(faces);
        _report.slivers = _slivers.size();
    }

    Mesh& _mesh;
    const double _tolerance, _thinHeight, _mostDrift, _mostStitchDrift;
    std::size_t& _mostNewFaces;
    bool& _isAtLimit;
    bool _isCutShort = false;
    std::vector<Extent>& _homes;
    std::vector<std::uint32_t>& _waiting;
    const std::vector<Triangle> _triangles;
    const EdgeTable _edges;
    const std::vector<TJunction> _found;
    std::unordered_map<std::uint32_t, CrowdedFace> _crowded;
    std::unordered_set<std::uint32_t> _slivers, _moved;
    TVertices _report;
};

} // namespace

TVertices insertTVertices(Mesh& mesh, TVertexState& state)
{
    return Pass(mesh, state).run();
}

} // namespace osgPMObjects::core
