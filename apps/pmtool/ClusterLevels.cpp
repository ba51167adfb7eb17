// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
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

/// Searches a small cell size with at most so many faces, by halving an interval of its logarithm. The number of faces does not
/// fall at every larger size, so a smaller size than the one found may do, too.
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

class ClusterLevels : public LevelMaker
{
public:
    explicit ClusterLevels(const core::Mesh& mesh) : _mesh(mesh) {}

    Json summary() const override { return Json::object(); }

    foundation::Result<MadeLevel> make(const LevelWish& wish) const override
    {
        const double diagonalOfCell = std::sqrt(3.0);
        Clustered clustered = core::ClusteredMesh();
        const double ms = millisecondsOf(
            [&]
            {
                clustered = wish.faces ? clusterToFaces(_mesh, *wish.faces)
                                       : core::clusterVertices(_mesh, wish.tolerance / diagonalOfCell);
            });
        if (!clustered) return clustered.error();
        core::compactMesh(clustered->mesh);
        Json row{{"level", wish.name},
                 {"triangles", clustered->mesh.faces.size()},
                 {"distance", clustered->cellSize * diagonalOfCell},
                 {"cellSize", clustered->cellSize},
                 {"lines", clustered->edges.size()},
                 {"points", clustered->points.size()},
                 {"ms", ms}};
        return MadeLevel{std::move(clustered->mesh), std::move(row)};
    }

private:
    const core::Mesh& _mesh;
};

} // namespace

std::unique_ptr<LevelMaker> clusterLevels(const core::Mesh& mesh)
{
    return std::make_unique<ClusterLevels>(mesh);
}

} // namespace pmtool
