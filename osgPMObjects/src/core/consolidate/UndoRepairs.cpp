// SPDX-License-Identifier: Apache-2.0
#include "UndoRepairs.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/TJunctions.h>
#include <osgPMObjects/core/mesh/UnionFind.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

/// The defects of a group of faces, each kind counted as in MeshCounts.
struct GroupDefects
{
    enum Kind
    {
        tJunctions,
        duplicates,
        degenerates,
        crowdedEdges,
    };
    std::array<std::uint32_t, 4> counts{};

    bool isWorseThan(const GroupDefects& other) const
    {
        for (std::size_t kind = 0; kind < counts.size(); ++kind)
            if (counts[kind] > other.counts[kind]) return true;
        return false;
    }
};

/// The faces of a mesh with the defects that concern several of them.
struct Examined
{
    std::vector<Triangle> all, proper; ///< proper: without those that repeat a corner
    EdgeTable edges;
    std::vector<TJunction> junctions;

    Examined(const Mesh& mesh, double diagonal)
        : all(positionTriangles(mesh)),
          proper(properTriangles(mesh)),
          edges(proper, mesh.positions.size()),
          junctions(findTJunctions(mesh.positions, proper, edges, kTJunctionTolerance * diagonal,
                                   OpenEdges::boundary)
                        .all)
    {
    }

    std::uint32_t endOf(std::uint32_t edge) const { return endsOf(proper, edges.sides(edge).front()).first; }
};

class RepairUndoer
{
public:
    RepairUndoer(Mesh& mesh, const Mesh& before, std::vector<std::uint32_t>& origins)
        : _mesh(mesh),
          _before(before),
          _origins(origins),
          _diagonal(diagonalOf(before)),
          _groups(mesh.positions.size()),
          _examined(before, _diagonal)
    {
        join(_examined);
    }

    std::size_t run()
    {
        std::size_t undone = 0;
        for (;;)
        {
            const Examined now(_mesh, _diagonal);
            join(now);
            for (std::size_t f = 0; f < _mesh.faces.size(); ++f)
                _groups.join(now.all[f][0], _examined.all[_origins[f]][0]);
            const auto worse = worseGroups(now);
            if (worse.empty()) return undone;
            undone += giveBack(worse);
        }
    }

private:
    using Groups = std::unordered_map<std::uint32_t, GroupDefects>; ///< by lowest position

    void join(const Examined& faces)
    {
        for (const Triangle& t : faces.all)
        {
            _groups.join(t[0], t[1]);
            _groups.join(t[0], t[2]);
        }
        for (const TJunction& t : faces.junctions)
            _groups.join(t.vertex, faces.endOf(t.edge));
    }

    Groups defectsOf(const Mesh& mesh, const Examined& faces)
    {
        Groups groups;
        const auto count = [&](std::uint32_t position, GroupDefects::Kind kind)
        { ++groups[_groups.root(position)].counts[kind]; };
        std::vector<std::uint32_t> vertices;
        for (const TJunction& t : faces.junctions)
            vertices.push_back(t.vertex);
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        for (const std::uint32_t vertex : vertices)
            count(vertex, GroupDefects::tJunctions);
        for (const Triangle& t : faces.all)
            if (repeatsCorner(t) || heightOf(mesh.positions[t[0]], mesh.positions[t[1]],
                                             mesh.positions[t[2]]) <= kDegenerateHeight * _diagonal)
                count(t[0], GroupDefects::degenerates);
        std::vector<Triangle> sorted;
        for (const Triangle& t : faces.proper)
            sorted.push_back(sortedCorners(t));
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t i = 1; i < sorted.size(); ++i)
            if (sorted[i] == sorted[i - 1]) count(sorted[i][0], GroupDefects::duplicates);
        for (std::uint32_t e = 0; e < faces.edges.size(); ++e)
            if (!faces.edges.isManifold(e)) count(faces.endOf(e), GroupDefects::crowdedEdges);
        return groups;
    }

    std::vector<std::uint32_t> worseGroups(const Examined& now)
    {
        const Groups was = defectsOf(_before, _examined);
        std::vector<std::uint32_t> worse;
        for (const auto& [group, defects] : defectsOf(_mesh, now))
        {
            const auto known = was.find(group);
            if (defects.isWorseThan(known == was.end() ? GroupDefects() : known->second))
                worse.push_back(group);
        }
        std::sort(worse.begin(), worse.end());
        return worse;
    }

    /// Returns how many faces were given back.
    std::size_t giveBack(const std::vector<std::uint32_t>& groups)
    {
        const auto isOfGroup = [&](std::uint32_t position)
        { return std::binary_search(groups.begin(), groups.end(), _groups.root(position)); };
        for (std::uint32_t p = 0; p < _before.positions.size(); ++p)
            if (isOfGroup(p)) _mesh.positions[p] = _before.positions[p];
        std::vector<Face> faces;
        std::vector<std::uint32_t> origins;
        std::size_t next = 0, back = 0;
        for (std::uint32_t f = 0; f < _before.faces.size(); ++f)
        {
            const bool goesBack = isOfGroup(_examined.all[f][0]);
            for (; next < _mesh.faces.size() && _origins[next] == f; ++next)
                if (!goesBack) faces.push_back(_mesh.faces[next]), origins.push_back(f);
            if (!goesBack) continue;
            Face face = _before.faces[f];
            for (std::uint32_t& wedge : face.wedges)
                wedge = wedgeAsItWas(wedge);
            faces.push_back(face);
            origins.push_back(f);
            ++back;
        }
        _mesh.faces = std::move(faces);
        _origins = std::move(origins);
        return back;
    }

    std::uint32_t wedgeAsItWas(std::uint32_t wedge)
    {
        const auto [known, isNew] = _wedges.try_emplace(wedge, 0);
        if (isNew) known->second = appendWedge(_mesh, wedgeOf(_before, wedge));
        return known->second;
    }

    Mesh& _mesh;
    const Mesh& _before;
    std::vector<std::uint32_t>& _origins;
    const double _diagonal;
    UnionFind _groups;                                        ///< of positions
    const Examined _examined;                                 ///< before the repairs
    std::unordered_map<std::uint32_t, std::uint32_t> _wedges; ///< by wedge of `before`: its copy
};

} // namespace

std::size_t undoWorseRepairs(Mesh& mesh, const Mesh& before, std::vector<std::uint32_t>& origins)
{
    return RepairUndoer(mesh, before, origins).run();
}

} // namespace osgPMObjects::core
