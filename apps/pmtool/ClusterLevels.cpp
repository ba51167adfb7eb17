// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/simplify/ToleranceSearch.h>
#include <osgPMObjects/core/simplify/VertexClustering.h>

#include "pmtool/LevelMaker.h"
#include "pmtool/Timing.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;
using Clustered = foundation::Result<core::ClusteredMesh>;

constexpr double kCellDiagonal = 1.7320508; ///< of a cube whose edge is 1

/// Searches a small cell size with at most so many faces, by halving an interval of its logarithm. The number
/// of faces does not fall at every larger size, so a smaller size than the one found may do, too.
Clustered clusterToFaces(const core::Mesh& mesh, std::size_t faces)
{
    constexpr int kHalvings = 20; // to a hundred-thousandth of the size
    double tooSmall = 1e-6 * core::diagonalOf(mesh), enough = 1.01 * core::diagonalOf(mesh);
    Clustered best = core::clusterVertices(mesh, enough);
    for (int i = 0; best && i < kHalvings; ++i)
    {
        const double size = std::sqrt(tooSmall * enough);
        Clustered tried = core::clusterVertices(mesh, size);
        if (!tried || tried->mesh.faces.size() > faces)
        {
            tooSmall = size;
            continue;
        }
        enough = size;
        best = std::move(tried);
    }
    return best;
}

/// Returns large clusters whose measured distance keeps the tolerance. A cell's diagonal does not bound it:
/// what becomes a line or a point is gone from the surface.
Clustered clusterWithin(const core::Mesh& mesh, double tolerance, const core::LevelMeter& meter)
{
    constexpr double kFiner = 1.25;
    for (double size = tolerance / kCellDiagonal;; size /= kFiner)
    {
        Clustered tried = core::clusterVertices(mesh, size);
        if (!tried || meter.measure(tried->mesh).maximum <= core::ToleranceSearch::kShare * tolerance)
            return tried;
    }
}

class ClusterLevels : public LevelMaker
{
public:
    ClusterLevels(const core::Mesh& mesh, double speckSize) : _mesh(mesh), _errors(mesh, speckSize) {}

    Json summary() const override { return Json::object(); }

    foundation::Result<MadeLevel> make(const LevelWish& wish) override
    {
        Clustered clustered = core::ClusteredMesh();
        const double ms = millisecondsOf(
            [&]
            {
                clustered = wish.faces ? clusterToFaces(_mesh, *wish.faces)
                                       : clusterWithin(_mesh, wish.tolerance, _errors.meter());
            });
        if (!clustered) return clustered.error();
        core::compactMesh(clustered->mesh);
        Json row{{"level", wish.name},
                 {"triangles", clustered->mesh.faces.size()},
                 {"distance", clustered->cellSize * kCellDiagonal},
                 {"cellSize", clustered->cellSize},
                 {"lines", clustered->edges.size()},
                 {"points", clustered->points.size()},
                 {"ms", ms}};
        MadeLevel level{std::move(clustered->mesh), std::move(row)};
        _errors.addTo(level, wish);
        return level;
    }

private:
    const core::Mesh& _mesh;
    LevelErrors _errors;
};

} // namespace

std::unique_ptr<LevelMaker> clusterLevels(const core::Mesh& mesh, double speckSize)
{
    return std::make_unique<ClusterLevels>(mesh, speckSize);
}

} // namespace pmtool
