// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>
#include <vector>

#include <osgPMObjects/core/consolidate/RemoveFaces.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/FirstAtPlace.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

namespace osgPMObjects::core
{

namespace
{

/// Removes the faces marked in `isDead`; the others keep their order.
std::size_t removeMarked(Mesh& mesh, const std::vector<bool>& isDead)
{
    std::size_t kept = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        if (!isDead[f]) mesh.faces[kept++] = mesh.faces[f];
    const std::size_t removed = mesh.faces.size() - kept;
    mesh.faces.resize(kept);
    return removed;
}

/// Faces sorted by their lowest, middle and highest corner and their number, with buckets by the lowest.
struct FacesByCorners
{
    struct Entry
    {
        std::uint32_t middle, highest, face;
        auto operator<=>(const Entry&) const = default;
    };
    std::vector<Entry> faces;
    std::vector<std::uint32_t> first; ///< by lowest corner; one more at the end

    FacesByCorners(std::span<const Triangle> triangles, std::size_t positionCount)
        : faces(triangles.size()), first(positionCount + 1, 0), _triangles(triangles)
    {
        for (const Triangle& t : triangles)
            ++first[std::min({t[0], t[1], t[2]}) + 1];
        for (std::size_t p = 1; p < first.size(); ++p)
            first[p] += first[p - 1];
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::uint32_t f = 0; f < triangles.size(); ++f)
        {
            const Triangle t = sortedCorners(triangles[f]);
            faces[next[t[0]]++] = {t[1], t[2], f};
        }
        for (std::size_t p = 0; p + 1 < first.size(); ++p)
            std::sort(faces.begin() + first[p], faces.begin() + first[p + 1]);
    }

    /// Whether the i-th and the j-th face have the same corners.
    bool isSame(std::size_t i, std::size_t j) const
    {
        return faces[i].middle == faces[j].middle && faces[i].highest == faces[j].highest &&
               lowestOf(faces[i].face) == lowestOf(faces[j].face);
    }

private:
    std::uint32_t lowestOf(std::uint32_t face) const
    {
        const Triangle& t = _triangles[face];
        return std::min({t[0], t[1], t[2]});
    }

    std::span<const Triangle> _triangles;
};

/// Whether sorting the corners keeps their orientation: equal for two faces with the same front.
bool isEvenTurn(const Triangle& t)
{
    return (t[0] < t[1]) == ((t[1] < t[2]) == (t[0] < t[2]));
}

/// The faces on one triple of positions; decides which are removed.
class SameCorners
{
public:
    SameCorners(Mesh& mesh, std::vector<bool>& isDead, DuplicateFaces& report)
        : _mesh(mesh), _isDead(isDead), _report(report)
    {
    }

    void judge(std::span<const std::uint32_t> faces, std::span<const Triangle> triangles)
    {
        std::uint32_t stays[2] = {kNone, kNone};
        for (const bool even : {false, true})
            for (const std::uint32_t f : faces)
                if (isEvenTurn(triangles[f]) == even) stays[even] = better(stays[even], f);
        for (const std::uint32_t f : faces)
            if (const std::uint32_t other = stays[isEvenTurn(triangles[f])]; f != other) drop(f, other);
        if (stays[0] != kNone && stays[1] != kNone)
            joinBacks(std::min(stays[0], stays[1]), std::max(stays[0], stays[1]));
    }

private:
    static constexpr std::uint32_t kNone = ~0u;

    const Material& materialOf(std::uint32_t face) const
    {
        return _mesh.materials[_mesh.faces[face].material];
    }

    std::uint32_t better(std::uint32_t known, std::uint32_t next) const
    {
        if (known == kNone) return next;
        return materialOf(known).isTransparent && !materialOf(next).isTransparent ? next : known;
    }

    void drop(std::uint32_t face, std::uint32_t other)
    {
        _isDead[face] = true;
        ++_report.removed;
        _report.hidden += _mesh.faces[face].material != _mesh.faces[other].material;
    }

    /// Merges or keeps two faces back to back.
    void joinBacks(std::uint32_t first, std::uint32_t second)
    {
        const Material &a = materialOf(first), &b = materialOf(second);
        if (a.isTwoSided || b.isTwoSided) // is visible from both sides already, at the depth of the other
        {
            const bool firstStays = a.isTwoSided && (!b.isTwoSided || !a.isTransparent || b.isTransparent);
            return firstStays ? drop(second, first) : drop(first, second);
        }
        if (a.state != b.state)
        {
            ++_report.kept;
            return;
        }
        _isDead[second] = true;
        ++_report.backToBack;
        _mesh.faces[first].material = twoSided(_mesh.faces[first].material);
    }

    /// Returns the same material drawn from both sides.
    std::uint32_t twoSided(std::uint32_t material)
    {
        Material both = _mesh.materials[material];
        both.isTwoSided = both.litFromBothSides = true;
        const auto found = std::find(_mesh.materials.begin(), _mesh.materials.end(), both);
        const auto number = static_cast<std::uint32_t>(found - _mesh.materials.begin());
        if (found == _mesh.materials.end()) _mesh.materials.push_back(both);
        return number;
    }

    Mesh& _mesh;
    std::vector<bool>& _isDead;
    DuplicateFaces& _report;
};

} // namespace

std::size_t removeDegenerateFaces(Mesh& mesh, double height)
{
    std::vector<bool> isDead;
    for (const Face& face : mesh.faces)
        isDead.push_back(
            repeatsCorner({mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)}) ||
            heightOf(mesh.at(face, 0), mesh.at(face, 1), mesh.at(face, 2)) <= height);
    return removeMarked(mesh, isDead);
}

DuplicateFaces removeDuplicateFaces(Mesh& mesh)
{
    std::vector<Triangle> triangles = positionTriangles(mesh);
    const std::vector<std::uint32_t> first = firstAtPlace(mesh.positions);
    for (Triangle& t : triangles)
        t = {first[t[0]], first[t[1]], first[t[2]]};
    DuplicateFaces report;
    std::vector<bool> isDead(triangles.size(), false);
    SameCorners same(mesh, isDead, report);
    std::vector<std::uint32_t> faces;
    const FacesByCorners sorted(triangles, mesh.positions.size());
    for (std::size_t i = 0; i < sorted.faces.size(); ++i)
    {
        faces.push_back(sorted.faces[i].face);
        if (i + 1 < sorted.faces.size() && sorted.isSame(i, i + 1)) continue;
        if (faces.size() > 1) same.judge(faces, triangles);
        faces.clear();
    }
    removeMarked(mesh, isDead);
    return report;
}

} // namespace osgPMObjects::core
