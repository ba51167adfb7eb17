// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/consolidate/Orient.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/UnionFind.h>

#include "Visibility.h"

namespace osgPMObjects::core
{

namespace
{

/// Number of rays for a patch.
constexpr int kRays = 48;
constexpr double kDecided = 0.25;
/// The most patches that are judged by rays.
constexpr std::size_t kMostJudged = 2048;
/// Boxes of the tree that all rays together may look at, and the most that a ray may look at on average.
/// Where many faces coincide or cross, each ray would look at all of them. The patches of known models need
/// up to 145 a ray; 2 048 patches may have 254 each.
constexpr std::uint64_t kMostBoxes = 50'000'000, kMostBoxesARay = 1024;
/// Least cosine between the directions from an edge into its two faces at which they fold back onto each
/// other.
constexpr double kFold = 0.5;

/// Two patches of opposite orientation along an edge.
struct Disagreement
{
    HalfEdge a, b;
};

class Orienter
{
public:
    explicit Orienter(Mesh& mesh)
        : _mesh(mesh),
          _triangles(positionTriangles(mesh)),
          _edges(_triangles, mesh.positions.size()),
          _patches(_triangles.size())
    {
    }

    Orientation run()
    {
        collect();
        if (!_disagreements.empty())
        {
            gatherDoubtful();
            judgeByOpenness();
            followNeighbours();
            turn();
        }
        return _report;
    }

private:
    struct Patch
    {
        std::vector<std::uint32_t> faces;
        double area = 0.0;
        bool isDecided = false;
        bool isTurned = false;
        bool isCutShort = false;
    };

    bool agree(HalfEdge a, HalfEdge b) const { return endsOf(_triangles, a) != endsOf(_triangles, b); }

    void collect()
    {
        for (std::uint32_t e = 0; e < _edges.size(); ++e)
        {
            const auto sides = _edges.sides(e);
            if (sides.size() != 2) continue;
            if (agree(sides[0], sides[1]))
                _patches.join(faceOf(sides[0]), faceOf(sides[1]));
            else
                _disagreements.push_back({sides[0], sides[1]});
        }
        for (std::uint32_t f = 0; f < _triangles.size(); ++f)
            _report.patches += _patches.root(f) == f;
    }

    void gatherDoubtful()
    {
        _numberOf.assign(_triangles.size(), kNone); // by root
        for (const Disagreement& d : _disagreements)
            for (const HalfEdge side : {d.a, d.b})
            {
                std::uint32_t& number = _numberOf[_patches.root(faceOf(side))];
                if (number != kNone) continue;
                number = static_cast<std::uint32_t>(_doubtful.size());
                _doubtful.emplace_back();
            }
        for (std::uint32_t f = 0; f < _triangles.size(); ++f)
            if (const std::uint32_t number = patchOf(f); number != kNone)
            {
                _doubtful[number].faces.push_back(f);
                _doubtful[number].area += glm::length(areaVector(f));
            }
        _report.doubtful = _doubtful.size();
    }

    std::uint32_t patchOf(std::uint32_t face) { return _numberOf[_patches.root(face)]; }

    glm::dvec3 areaVector(std::uint32_t f) const
    {
        const auto& at = _mesh.positions;
        const Triangle& t = _triangles[f];
        return glm::cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]);
    }

    std::vector<Patch*> largestFirst()
    {
        std::vector<Patch*> patches;
        for (Patch& patch : _doubtful)
            patches.push_back(&patch);
        std::stable_sort(patches.begin(), patches.end(),
                         [](const Patch* a, const Patch* b) { return a->area > b->area; });
        return patches;
    }

    void judgeByOpenness()
    {
        const TriangleTree tree(_mesh.positions, _triangles);
        std::vector<Patch*> patches = largestFirst();
        patches.resize(std::min(patches.size(), kMostJudged));
        const std::uint64_t boxesARay = std::min(kMostBoxesARay, kMostBoxes / (2 * kRays * patches.size()));
        parallelShares(patches.size(), 4,
                       [&](std::size_t first, std::size_t last, std::size_t)
                       {
                           for (std::size_t i = first; i < last; ++i)
                               judge(*patches[i], tree, boxesARay);
                       });
        _report.unjudged = _doubtful.size() - patches.size();
        for (const Patch* patch : patches)
            _report.unjudged += patch->isCutShort;
    }

    void judge(Patch& patch, const TriangleTree& tree, std::uint64_t boxesARay) const
    {
        const Openness open = openness(_mesh.positions, _triangles, patch.faces, tree, kRays, boxesARay);
        patch.isCutShort = open.isCutShort;
        patch.isDecided = std::abs(open.value) > kDecided;
        patch.isTurned = patch.isDecided && open.value < 0.0;
    }

    /// Takes the largest neighbour first.
    void followNeighbours()
    {
        std::vector<std::vector<Disagreement>> around(_doubtful.size());
        for (const Disagreement& d : _disagreements)
            if (patchOf(faceOf(d.a)) != patchOf(faceOf(d.b)) && fold(d) < kFold)
            {
                around[patchOf(faceOf(d.a))].push_back(d);
                around[patchOf(faceOf(d.b))].push_back({d.b, d.a});
            }
        std::vector<Patch*> waiting = largestFirst();
        std::stable_partition(waiting.begin(), waiting.end(), [](const Patch* p) { return p->isDecided; });
        for (Patch* first : waiting)
        {
            std::vector<Patch*> known{first};
            first->isDecided = true;
            for (std::size_t i = 0; i < known.size(); ++i)
                for (const Disagreement& d : around[static_cast<std::size_t>(known[i] - _doubtful.data())])
                {
                    Patch& other = _doubtful[patchOf(faceOf(d.b))];
                    if (other.isDecided) continue;
                    other.isDecided = true;
                    other.isTurned = !known[i]->isTurned;
                    known.push_back(&other);
                }
        }
    }

    /// The cosine between the directions from the edge into its two faces.
    double fold(const Disagreement& d) const
    {
        const auto inward = [this](HalfEdge side)
        {
            const auto [from, to] = endsOf(_triangles, side);
            const glm::dvec3 along = glm::normalize(_mesh.positions[to] - _mesh.positions[from]);
            const glm::dvec3 in =
                _mesh.positions[_triangles[faceOf(side)]
                                          [static_cast<std::size_t>(cornerOf(previousSide(side)))]] -
                _mesh.positions[from];
            const glm::dvec3 across = in - glm::dot(in, along) * along;
            const double length = glm::length(across);
            return length > 0.0 ? across / length : across;
        };
        return glm::dot(inward(d.a), inward(d.b));
    }

    void turn()
    {
        for (const Disagreement& d : _disagreements)
            _report.disagreements +=
                _doubtful[patchOf(faceOf(d.a))].isTurned == _doubtful[patchOf(faceOf(d.b))].isTurned;
        for (const Patch& patch : _doubtful)
            if (patch.isTurned)
                for (const std::uint32_t f : patch.faces)
                {
                    turnFace(_mesh, f, false);
                    ++_report.turnedFaces;
                }
    }

    static constexpr std::uint32_t kNone = ~0u;

    Mesh& _mesh;
    const std::vector<Triangle> _triangles;
    const EdgeTable _edges;
    UnionFind _patches; ///< of faces
    std::vector<Disagreement> _disagreements;
    std::vector<std::uint32_t> _numberOf; ///< in _doubtful, by the root face of a patch
    std::vector<Patch> _doubtful;
    Orientation _report;
};

} // namespace

Orientation orientFaces(Mesh& mesh)
{
    return Orienter(mesh).run();
}

} // namespace osgPMObjects::core
