// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/TriangleDistance.h>
#include <osgPMObjects/core/simplify/Simplify.h>
#include <osgTerrainROAM/core/vdpm/BuildForest.h>
#include <osgTerrainROAM/core/vdpm/SurfaceForest.h>

#include "SplitBall.h"

namespace osgTerrainROAM::core
{

namespace
{

using osgPMObjects::core::Mesh;

/// Moves the samples from face to face while the mesh is collapsed, and measures what each collapse changes.
class SurfaceMeter : public CollapseWitness
{
public:
    SurfaceMeter(const std::vector<glm::dvec3>& positions, std::span<const Triangle> triangles)
        : _positions(positions),
          _points(positions),
          _cones(positions.size()),
          _next(positions.size() + triangles.size(), kNone),
          _first(triangles.size(), kNone)
    {
        for (std::uint32_t f = 0; f < triangles.size(); ++f)
        {
            const Triangle& t = triangles[f];
            const NormalCone cone = NormalCone::of(normalOf(t));
            for (const std::uint32_t v : t)
                _cones[v] = _cones[v].joined(cone);
            _first[f] = static_cast<std::uint32_t>(_points.size());
            _points.push_back((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3.0);
            _cones.push_back(cone);
        }
    }

    bool collapse(const CollapsedStar& star) override
    {
        std::uint32_t points = star.v0; // positions that are left lie in no list
        NormalCone cone = _cones[star.v0];
        for (const std::uint32_t f : star.faces)
            while (_first[f] != kNone)
            {
                const std::uint32_t point = std::exchange(_first[f], _next[_first[f]]);
                _next[point] = std::exchange(points, point);
                cone = cone.joined(_cones[point]);
            }
        for (const auto& corners : {star.corners, star.floorCorners})
            for (const Triangle& t : corners)
                cone = cone.joined(NormalCone::of(normalOf(t)));
        double error = 0.0;
        while (points != kNone)
        {
            const std::uint32_t point = std::exchange(points, _next[points]);
            error = std::max(error, moveToNearest(point, star));
        }
        _bounds.push_back(ballAround(star.corners, _positions, error));
        _splitCones.push_back(cone);
        return true;
    }

    /// By split.
    std::vector<SplitBound> bounds() const { return {_bounds.rbegin(), _bounds.rend()}; }
    std::vector<NormalCone> cones() const { return {_splitCones.rbegin(), _splitCones.rend()}; }

private:
    glm::dvec3 normalOf(const Triangle& t) const
    {
        return glm::cross(_positions[t[1]] - _positions[t[0]], _positions[t[2]] - _positions[t[0]]);
    }

    /// Gives a sample to the nearest face of a floor. Returns its distance.
    double moveToNearest(std::uint32_t point, const CollapsedStar& star)
    {
        double least = std::numeric_limits<double>::infinity();
        std::uint32_t nearest = star.floorFaces[0];
        for (std::size_t i = 0; i < star.floorFaces.size(); ++i)
        {
            const Triangle& t = star.floorCorners[i];
            const double distance = glm::distance(
                _points[point], osgPMObjects::core::nearestPoint(_points[point], _positions[t[0]],
                                                                 _positions[t[1]], _positions[t[2]]));
            if (distance >= least) continue;
            least = distance;
            nearest = star.floorFaces[i];
        }
        _next[point] = std::exchange(_first[nearest], point);
        return least;
    }

    const std::vector<glm::dvec3>& _positions;
    std::vector<glm::dvec3> _points;          ///< samples: positions, then middles of faces
    std::vector<NormalCone> _cones;           ///< by sample: of the faces at it
    std::vector<std::uint32_t> _next, _first; ///< lists of samples: by sample, by face
    std::vector<SplitBound> _bounds;          ///< by collapse
    std::vector<NormalCone> _splitCones;
};

} // namespace

foundation::Result<BoundedForest> surfaceForest(const Mesh& mesh)
{
    if (mesh.faces.empty()) return foundation::Error{"mesh", "it has no face", "use another"};
    const std::vector<Triangle> triangles = osgPMObjects::core::positionTriangles(mesh);
    const osgPMObjects::core::EdgeTable edges(triangles, mesh.positions.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        if (!edges.isManifold(e))
            return foundation::Error{"mesh", "an edge has more than two faces",
                                     "clean it with pmtool consolidate"};
    std::vector<EdgeCollapse> collapses;
    for (const auto& step : osgPMObjects::core::simplify(mesh).steps)
        collapses.push_back({step.from, step.to});
    SurfaceMeter meter(mesh.positions, triangles);
    VertexForest forest =
        buildForest(triangles, static_cast<std::uint32_t>(mesh.positions.size()), collapses, &meter);
    std::vector<glm::dvec3> positions;
    for (const std::uint32_t v : forest.original)
        positions.push_back(mesh.positions[v]);
    return nestBounds(std::move(forest), std::move(positions), meter.bounds(), meter.cones());
}

} // namespace osgTerrainROAM::core
