// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cassert>
#include <span>

#include <osgMultiTriangulation/core/build/BuildTree.h>
#include <osgMultiTriangulation/core/structure/ErrorCode.h>
#include <osgMultiTriangulation/core/structure/StarRing.h>

#include "Simplification.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Turns the record of a simplification round: what was removed last is the first fragment.
class TreeAssembly
{
public:
    TreeAssembly(const SurfaceMesh& mesh, const Simplification& simplification)
        : _mesh(mesh),
          _done(simplification),
          _numbers(simplification.corners().size(), kNone),
          _places(mesh.points.size(), kNone)
    {
    }

    BuiltTree assemble()
    {
        addRoot();
        for (std::size_t r = _done.removals().size(); r-- > 0;)
            addFragment(_done.removals()[r]);
        _built.triangle.assign(_numbers.begin(), _numbers.begin() + _mesh.triangles.size());
        return std::move(_built);
    }

private:
    void addRoot()
    {
        const LiveSurface& surface = _done.surface();
        MeasuredMesh& rest = _built.rest;
        for (std::uint32_t v = 0; v < _mesh.points.size(); ++v)
            if (surface.isThere(v)) addPoint(v);
        rest.mesh.points = _built.tree.points;
        for (std::uint32_t slot = 0; slot < surface.slots(); ++slot)
        {
            const LiveSurface::Face& face = surface.face(slot);
            if (face.number == kNone) continue;
            Triangle corners = face.corners;
            for (std::uint32_t& corner : corners)
                corner = _places[corner];
            addTriangle(face.number, kNone, corners);
            rest.mesh.triangles.push_back(_built.tree.corners.back());
            rest.errors.push_back(_built.tree.errors.back());
            rest.firstHidden.push_back(static_cast<std::uint32_t>(rest.hidden.size()));
            const std::span<const SurfacePoint> removed = surface.removedIn(slot);
            rest.hidden.insert(rest.hidden.end(), removed.begin(), removed.end());
        }
        rest.firstHidden.push_back(static_cast<std::uint32_t>(rest.hidden.size()));
        _built.tree.rootPoints = static_cast<std::uint32_t>(_built.tree.points.size());
        _built.tree.rootTriangles = _built.tree.triangleCount();
    }

    void addFragment(const Removal& removal)
    {
        MultiTriangulation& tree = _built.tree;
        const auto number = static_cast<std::uint32_t>(tree.fragments.size());
        Fragment fragment;
        fragment.firstTriangle = tree.triangleCount();
        fragment.triangleCount = removal.starCount;
        fragment.firstFloor = static_cast<std::uint32_t>(tree.floors.size());
        fragment.floorCount = removal.createdCount;
        addPoint(removal.vertex);
        for (std::uint32_t c = 0; c < removal.createdCount; ++c)
        {
            const std::uint32_t floor = _numbers[removal.firstCreated + c];
            tree.lower[floor] = number;
            tree.floors.push_back(floor);
        }
        addStar(removal, number);
        tree.fragments.push_back(fragment);
    }

    /// Adds the triangles of a star in the order of its ring, which follows from the floor.
    void addStar(const Removal& removal, std::uint32_t number)
    {
        MultiTriangulation& tree = _built.tree;
        std::array<Triangle, StarRing::kMost> floor;
        for (std::uint32_t c = 0; c < removal.createdCount; ++c)
            floor[c] = tree.corners[_numbers[removal.firstCreated + c]];
        StarRing ring;
        [[maybe_unused]] const bool isFound =
            findStarRing(std::span(floor).first(removal.createdCount), tree.points, tree.points.back(), ring);
        assert(isFound && ring.triangles() == removal.starCount);
        for (std::size_t i = 0; i < ring.triangles(); ++i)
        {
            const Triangle corners = ring.triangle(i, tree.rootPoints + number);
            for (std::uint32_t s = 0; s < removal.starCount; ++s)
            {
                const std::uint32_t created = _done.stars()[removal.firstStar + s];
                if (_numbers[created] == kNone && hasSide(created, corners[0], corners[1]))
                    addTriangle(created, number, corners);
            }
        }
    }

    /// Whether a triangle has a side, given by points of the tree.
    bool hasSide(std::uint32_t created, std::uint32_t from, std::uint32_t to) const
    {
        const Triangle& t = _done.corners()[created];
        for (int c = 0; c < 3; ++c)
            if (_places[t[c]] == from && _places[t[(c + 1) % 3]] == to) return true;
        return false;
    }

    void addPoint(std::uint32_t v)
    {
        _places[v] = static_cast<std::uint32_t>(_built.points.size());
        _built.points.push_back(v);
        _built.tree.points.push_back(_mesh.points[v]);
    }

    void addTriangle(std::uint32_t created, std::uint32_t upper, const Triangle& corners)
    {
        MultiTriangulation& tree = _built.tree;
        _numbers[created] = tree.triangleCount();
        tree.corners.push_back(corners);
        tree.errors.push_back(errorOfCode(codeOfError(_done.errors()[created])));
        tree.upper.push_back(upper);
        tree.lower.push_back(kNone);
    }

    const SurfaceMesh& _mesh;
    const Simplification& _done;
    std::vector<std::uint32_t> _numbers; ///< by triangle as created: its number in the tree
    std::vector<std::uint32_t> _places;  ///< by point of the mesh: its number in the tree
    BuiltTree _built;
};

} // namespace

BuiltTree buildTree(const MeasuredMesh& input, const TreeOptions& options)
{
    Simplification simplification(input, options.isLocked);
    simplification.run(options.keep);
    return TreeAssembly(input.mesh, simplification).assemble();
}

} // namespace osgMultiTriangulation::core
