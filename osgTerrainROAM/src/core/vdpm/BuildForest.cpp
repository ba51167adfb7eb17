// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <utility>

#include <osgPMObjects/core/order/TriangleAdjacency.h>
#include <osgTerrainROAM/core/vdpm/BuildForest.h>

namespace osgTerrainROAM::core
{

namespace
{

/// The mesh while it is collapsed. Faces keep their numbers; those of the mesh first, no others appear.
class CollapsingMesh
{
public:
    CollapsingMesh(std::span<const Triangle> triangles, std::uint32_t vertexCount)
        : _corners(triangles.begin(), triangles.end()), _faceOf(vertexCount, kNone)
    {
        const osgPMObjects::core::TriangleAdjacency adjacency(triangles);
        _across.reserve(_corners.size());
        for (std::uint32_t f = 0; f < _corners.size(); ++f)
        {
            _across.push_back(adjacency.neighbours(f));
            for (const std::uint32_t v : _corners[f])
                _faceOf[v] = f;
        }
    }

    bool isThere(std::uint32_t v) const { return _faceOf[v] != kNone; }
    bool isFaceThere(std::uint32_t f) const { return _corners[f][0] != kNone; }
    const Triangle& corners(std::uint32_t f) const { return _corners[f]; }
    std::uint32_t faceCount() const { return static_cast<std::uint32_t>(_corners.size()); }

    static std::uint32_t cornerAt(const Triangle& t, std::uint32_t v)
    {
        return t[0] == v ? 0 : t[1] == v ? 1 : 2;
    }

    /// The faces around a vertex, counter-clockwise; on a border from the first to the last.
    void gatherStar(std::uint32_t v, std::vector<std::uint32_t>& star) const
    {
        star.clear();
        std::uint32_t first = _faceOf[v];
        for (std::uint32_t f = first;;) // clockwise to the border, or round
        {
            const std::uint32_t before = _across[f][cornerAt(_corners[f], v)];
            if (before == _faceOf[v]) break;
            if (before == kNone)
            {
                first = f;
                break;
            }
            f = before;
        }
        for (std::uint32_t f = first; f != kNone;)
        {
            star.push_back(f);
            f = _across[f][(cornerAt(_corners[f], v) + 2) % 3];
            if (f == first) break;
        }
    }

    /// A collapse as a vsplit, by numbers of this mesh, with its fL and fR (kNone: on that side there is a
    /// border).
    struct Edge
    {
        VertexSplit split;
        std::uint32_t fL = kNone, fR = kNone;
    };

    /// Finds the faces at an edge; none when there is no such edge, or collapsing it would not leave a
    /// manifold. `star`: of v0.
    std::optional<Edge> edge(const EdgeCollapse& c, std::span<const std::uint32_t> star)
    {
        Edge found;
        found.split.v1 = c.v1;
        std::uint32_t vl = kNone, vr = kNone;
        for (const std::uint32_t f : star)
        {
            const Triangle& t = _corners[f];
            const std::uint32_t at = cornerAt(t, c.v0);
            if (t[(at + 1) % 3] == c.v1) // v0, v1, vr
            {
                found.fR = f;
                vr = t[(at + 2) % 3];
                found.split.f[2] = _across[f][(at + 1) % 3];
                found.split.f[3] = _across[f][(at + 2) % 3];
            }
            else if (t[(at + 2) % 3] == c.v1) // v1, v0, vl
            {
                found.fL = f;
                vl = t[(at + 1) % 3];
                found.split.f[0] = _across[f][at];
                found.split.f[1] = _across[f][(at + 1) % 3];
            }
        }
        if (found.fL == kNone && found.fR == kNone) return std::nullopt;
        // A side without a face on v1's side and v0's would go as a whole, and a fan without faces would
        // leave v1 alone.
        if (found.fL != kNone && !found.split.hasLeft()) return std::nullopt;
        if (found.fR != kNone && !found.split.hasRight()) return std::nullopt;
        if (found.split.f[0] == kNone && found.split.f[3] == kNone) return std::nullopt;
        const bool areBothOfThree =
            found.split.f[0] == found.split.f[3] && found.split.f[1] == found.split.f[2];
        if (areBothOfThree) return std::nullopt; // a tetrahedron
        return isLinked(c, star, vl, vr) ? std::optional(found) : std::nullopt;
    }

    void collapse(const EdgeCollapse& c, const Edge& edge, std::span<const std::uint32_t> star)
    {
        if (edge.fL != kNone) join(edge.split.f[0], edge.split.f[1], edge.fL);
        if (edge.fR != kNone) join(edge.split.f[2], edge.split.f[3], edge.fR);
        for (const std::uint32_t f : star)
            if (f != edge.fL && f != edge.fR) _corners[f][cornerAt(_corners[f], c.v0)] = c.v1;
        for (const std::uint32_t gone : {edge.fL, edge.fR})
        {
            if (gone == kNone) continue;
            const auto& f = edge.split.f;
            const std::uint32_t left = gone == edge.fL ? (f[0] != kNone ? f[0] : f[1])
                                       : f[3] != kNone ? f[3]
                                                       : f[2];
            for (const std::uint32_t v : _corners[gone])
                if (v != c.v0) _faceOf[v] = left;
            _corners[gone] = {kNone, kNone, kNone};
        }
        _faceOf[c.v0] = kNone;
    }

private:
    /// The link condition: v0 and v1 have no other common neighbours than vl and vr, and where both lie on a
    /// border, so does the edge between them.
    bool isLinked(const EdgeCollapse& c, std::span<const std::uint32_t> star, std::uint32_t vl,
                  std::uint32_t vr)
    {
        if (vl == vr) return false;
        gatherStar(c.v1, _around);
        const auto isOnBorder = [&](std::span<const std::uint32_t> around, std::uint32_t v)
        {
            const std::uint32_t first = around.front();
            return _across[first][cornerAt(_corners[first], v)] == kNone;
        };
        if (vl != kNone && vr != kNone && isOnBorder(star, c.v0)) return false;
        for (const std::uint32_t f : _around)
            for (const std::uint32_t v : _corners[f])
                if (v != c.v0 && v != c.v1 && v != vl && v != vr)
                    for (const std::uint32_t g : star)
                        if (std::ranges::find(_corners[g], v) != _corners[g].end()) return false;
        return true;
    }

    void join(std::uint32_t a, std::uint32_t b, std::uint32_t between)
    {
        if (a != kNone) std::ranges::replace(_across[a], between, b);
        if (b != kNone) std::ranges::replace(_across[b], between, a);
    }

    std::vector<Triangle> _corners; ///< by face
    std::vector<std::array<std::uint32_t, 3>> _across;
    std::vector<std::uint32_t> _faceOf; ///< by vertex: one of its faces
    std::vector<std::uint32_t> _around;
};

/// Records the collapses, then numbers them from the last to the first.
class ForestAssembly
{
public:
    ForestAssembly(std::span<const Triangle> triangles, std::uint32_t vertexCount)
        : _mesh(triangles, vertexCount),
          _touched(triangles.size(), kNone),
          _maker(triangles.size(), kNone),
          _made(vertexCount, kNone)
    {
    }

    void collapse(std::span<const EdgeCollapse> collapses, CollapseWitness* witness)
    {
        for (const EdgeCollapse& c : collapses)
        {
            if (!_mesh.isThere(c.v0) || !_mesh.isThere(c.v1)) continue;
            _mesh.gatherStar(c.v0, _star);
            const auto edge = _mesh.edge(c, _star);
            if (!edge) continue;
            if (witness && !show(c, *edge, *witness)) continue;
            const auto step = static_cast<std::uint32_t>(_steps.size());
            for (const std::uint32_t f : _star)
            {
                if (_touched[f] != kNone) _needs.emplace_back(_touched[f], step);
                _touched[f] = step;
            }
            for (const std::uint32_t f : {edge->fL, edge->fR})
                if (f != kNone) _maker[f] = step;
            _made[c.v0] = step;
            _mesh.collapse(c, *edge, _star);
            _steps.push_back(edge->split);
            _v0.push_back(c.v0);
            _lefts.push_back(edge->fL);
        }
    }

    VertexForest assemble()
    {
        numberVertices();
        const std::uint32_t count = splitCount();
        for (std::uint32_t f = 0; f < _mesh.faceCount(); ++f)
            if (_mesh.isFaceThere(f))
            {
                Triangle corners = _mesh.corners(f);
                for (std::uint32_t& v : corners)
                    v = _numbers[v];
                _rootFace.emplace_back(f, static_cast<std::uint32_t>(_forest.rootFaces.size()));
                _forest.rootFaces.push_back(corners);
            }
        _forest.splits.resize(count);
        _forest.firstSplit.assign(_forest.vertexCount(), kNone);
        _forest.nextSplit.assign(count, kNone);
        _forest.parent.assign(count, kNone);
        std::vector<std::uint32_t> last(_forest.vertexCount(), kNone);
        for (std::uint32_t w = 0; w < count; ++w)
            addSplit(w, last);
        addDependencies();
        return std::move(_forest);
    }

private:
    std::uint32_t splitCount() const { return static_cast<std::uint32_t>(_steps.size()); }
    std::uint32_t splitOf(std::uint32_t step) const { return splitCount() - 1 - step; }

    bool show(const EdgeCollapse& c, const CollapsingMesh::Edge& edge, CollapseWitness& witness)
    {
        _starCorners.clear();
        _floorFaces.clear();
        _floorCorners.clear();
        for (const std::uint32_t f : _star)
        {
            Triangle t = _mesh.corners(f);
            _starCorners.push_back(t);
            if (f == edge.fL || f == edge.fR) continue;
            t[CollapsingMesh::cornerAt(t, c.v0)] = c.v1;
            _floorFaces.push_back(f);
            _floorCorners.push_back(t);
        }
        return witness.collapse({c.v0, c.v1, _star, _starCorners, _floorFaces, _floorCorners});
    }

    void numberVertices()
    {
        _numbers.assign(_made.size(), kNone);
        for (std::uint32_t v = 0; v < _made.size(); ++v)
            if (_made[v] == kNone && _mesh.isThere(v))
            {
                _numbers[v] = _forest.rootVertices++;
                _forest.original.push_back(v);
            }
        for (std::uint32_t step = splitCount(); step-- > 0;)
        {
            _numbers[_v0[step]] = static_cast<std::uint32_t>(_forest.original.size());
            _forest.original.push_back(_v0[step]);
        }
    }

    void addSplit(std::uint32_t w, std::vector<std::uint32_t>& last)
    {
        const VertexSplit& step = _steps[splitOf(w)];
        VertexSplit& split = _forest.splits[w];
        split.v1 = _numbers[step.v1];
        for (int i = 0; i < 4; ++i)
            split.f[i] = step.f[i] == kNone ? kNone : numberOfFace(step.f[i]);
        std::uint32_t& before = last[split.v1];
        _forest.parent[w] = before != kNone ? before : _forest.makerOfVertex(split.v1);
        (before != kNone ? _forest.nextSplit[before] : _forest.firstSplit[split.v1]) = w;
        before = w;
    }

    std::uint32_t numberOfFace(std::uint32_t f) const
    {
        if (_maker[f] == kNone)
            return std::ranges::lower_bound(_rootFace, f, {}, &std::pair<std::uint32_t, std::uint32_t>::first)
                ->second;
        const std::uint32_t split = splitOf(_maker[f]);
        return f == _lefts[_maker[f]] ? _forest.fL(split) : _forest.fR(split);
    }

    void addDependencies()
    {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> needs; // split, what it needs
        needs.reserve(_needs.size() + 5 * _steps.size());
        for (const auto& [finer, coarser] : _needs)
            needs.emplace_back(splitOf(finer), splitOf(coarser));
        for (std::uint32_t w = 0; w < splitCount(); ++w)
        {
            if (_forest.parent[w] != kNone) needs.emplace_back(w, _forest.parent[w]);
            for (const std::uint32_t f : _forest.splits[w].f)
                if (f != kNone && _forest.makerOfFace(f) != kNone)
                    needs.emplace_back(w, _forest.makerOfFace(f));
        }
        std::ranges::sort(needs);
        needs.erase(std::unique(needs.begin(), needs.end()), needs.end());
        _forest.firstDependency.assign(splitCount() + 1, 0);
        _forest.dependencies.reserve(needs.size());
        for (const auto& [split, needed] : needs)
        {
            ++_forest.firstDependency[split + 1];
            _forest.dependencies.push_back(needed);
        }
        for (std::uint32_t w = 0; w < splitCount(); ++w)
            _forest.firstDependency[w + 1] += _forest.firstDependency[w];
    }

    CollapsingMesh _mesh;
    std::vector<std::uint32_t> _star, _floorFaces;
    std::vector<Triangle> _starCorners, _floorCorners;
    std::vector<VertexSplit> _steps; ///< by step, in numbers of the mesh
    std::vector<std::uint32_t> _v0, _lefts;
    std::vector<std::uint32_t> _touched, _maker; ///< by face: the last step that changed it, that removed it
    std::vector<std::uint32_t> _made;            ///< by vertex: the step that removed it
    std::vector<std::pair<std::uint32_t, std::uint32_t>> _needs;    ///< steps: finer, coarser
    std::vector<std::pair<std::uint32_t, std::uint32_t>> _rootFace; ///< number in the mesh, in the forest
    std::vector<std::uint32_t> _numbers;                            ///< by vertex: in the forest
    VertexForest _forest;
};

} // namespace

VertexForest buildForest(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                         std::span<const EdgeCollapse> collapses, CollapseWitness* witness)
{
    ForestAssembly assembly(triangles, vertexCount);
    assembly.collapse(collapses, witness);
    return assembly.assemble();
}

} // namespace osgTerrainROAM::core
