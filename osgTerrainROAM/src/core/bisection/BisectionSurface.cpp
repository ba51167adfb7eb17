// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>

#include <osgTerrainROAM/core/bisection/BisectionSurface.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Places the middles of all bases below a triangle. The middle of two points is the same in whichever order,
/// so both triangles at a base find the same place.
class MiddlePlacer
{
public:
    MiddlePlacer(const BisectionSurface& surface, const SurfaceShape& shape, std::vector<glm::dvec3>& points)
        : _surface(surface), _shape(shape), _points(points)
    {
    }

    void place(const BisectorNeighbours& at, const std::array<glm::dvec3, 3>& corners) const
    {
        if (at.self.level() >= _surface.levels()) return;
        const glm::dvec3 middle = 0.5 * (corners[0] + corners[1]);
        _points[_surface.vertexOf(at)] = _shape(middle);
        place(at.half(0), {corners[2], corners[0], middle});
        place(at.half(1), {corners[1], corners[2], middle});
    }

private:
    const BisectionSurface& _surface;
    const SurfaceShape& _shape;
    std::vector<glm::dvec3>& _points;
};

} // namespace

BisectionSurface::BisectionSurface(CoarseMesh mesh, int levels, const SurfaceShape& shape)
    : _mesh(std::move(mesh)), _levels(levels)
{
    assert(levels >= 1 && levels <= 24 && std::uint64_t{_mesh.sides()} << levels < 1u << 31);
    for (const glm::dvec3& point : _mesh.points())
        _points.push_back(shape(point));
    for (std::uint32_t face = 0; face < _mesh.faces(); ++face)
        _points.push_back(shape(_mesh.centre(face)));
    _firstMiddle = static_cast<std::uint32_t>(_points.size());
    _points.resize(_points.size() + (std::size_t{_mesh.sides()} << levels));
    const MiddlePlacer placer(*this, shape, _points);
    for (std::uint32_t side = 0; side < _mesh.sides(); ++side)
        placer.place(neighboursOf(_mesh, {side, 1}),
                     {_mesh.points()[_mesh.origin(side)], _mesh.points()[_mesh.origin(_mesh.next(side))],
                      _mesh.centre(_mesh.face(side))});
}

std::uint32_t BisectionSurface::vertexOf(const BisectorNeighbours& at) const
{
    const auto place = [this](Bisector t) { return (t.side << _levels) + t.node; };
    const std::uint32_t own = place(at.self);
    return _firstMiddle + (at.base.exists() ? std::min(own, place(at.base)) : own);
}

CornerVertices BisectionSurface::rootCorners(std::uint32_t side) const
{
    return {_mesh.origin(side), _mesh.origin(_mesh.next(side)),
            static_cast<std::uint32_t>(_mesh.points().size()) + _mesh.face(side)};
}

CornerVertices BisectionSurface::cornersOf(Bisector t) const
{
    BisectorNeighbours at = neighboursOf(_mesh, {t.side, 1});
    CornerVertices corners = rootCorners(t.side);
    for (int bit = t.level(); bit-- > 0;)
    {
        const unsigned which = t.node >> bit & 1u;
        const std::uint32_t middle = vertexOf(at);
        corners = which == 0 ? CornerVertices{corners[2], corners[0], middle}
                             : CornerVertices{corners[1], corners[2], middle};
        at = at.half(which);
    }
    return corners;
}

} // namespace osgTerrainROAM::core
