// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgMultiTriangulation/core/split/BorderFit.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>

#include "JobQueue.h"
#include "MeshSource.h"
#include "PartJobs.h"

namespace osgMultiTriangulation::core
{

ForestReport reportOf(const Partition& partition, const std::vector<std::uint32_t>& locked,
                      std::uint32_t mainPart)
{
    ForestReport report;
    report.rectangles = partition.rectangles;
    report.trees = static_cast<std::uint32_t>(partition.parts.size());
    report.mainPart = mainPart;
    report.smallestTree = kNone;
    for (std::uint32_t p = 0; p < partition.parts.size(); ++p)
    {
        if (!partition.parts[p].isWhole()) continue;
        report.largestTree = std::max(report.largestTree, partition.parts[p].points);
        report.smallestTree = std::min(report.smallestTree, partition.parts[p].points);
        report.borderPoints += static_cast<double>(locked[p]) / partition.rectangles;
    }
    return report;
}

Partition partitionFor(const SurfaceMesh& mesh, const ForestOptions& options)
{
    const auto points = static_cast<double>(mesh.points.size());
    std::uint32_t count = options.treeCount;
    if (count == 0)
        count = balancedTreeCount(points, options.border ? *options.border : fitBorder(mesh, options.where));
    return partitionPoints(mesh.points, points / count, options.where);
}

foundation::Result<BuiltForest> buildForest(const SurfaceMesh& mesh, const ForestOptions& options)
{
    const Partition partition = partitionFor(mesh, options);
    const MeshSource source(mesh, partition);
    JobQueue queue(partition, options);
    std::vector<TreeRecord> records(partition.parts.size());
    std::vector<PartMesh> rests(partition.parts.size());
    std::vector<std::uint32_t> locked(partition.parts.size());
    queue.run(
        [&](std::uint32_t part)
        {
            PartHalves halves;
            for (std::size_t place = 0; place < halves.size(); ++place)
                if (const std::uint32_t half = partition.parts[part].halves[place]; half != kNone)
                    halves[place] = std::move(rests[half]);
            BuiltPart built = buildPart(source, partition, part, std::move(halves));
            records[part] = std::move(built.record);
            rests[part] = std::move(built.rest);
            locked[part] = built.locked;
        });
    if (queue.isStopped()) return foundation::Error{"the build", "was stopped", "start it again"};
    BuiltForest built;
    for (std::uint32_t part = 0; part < records.size(); ++part)
    {
        const std::uint32_t parent = partition.parts[part].parent;
        built.forest.trees.push_back({std::move(records[part].part), parent, {}});
        if (parent == kNone) continue;
        const std::size_t place = partition.parts[parent].halves[0] == part ? 0 : 1;
        built.forest.trees.back().parentTriangles = std::move(records[parent].childRoots[place]);
    }
    built.report =
        reportOf(partition, locked, static_cast<std::uint32_t>(built.forest.trees[0].part.points.size()));
    return built;
}

} // namespace osgMultiTriangulation::core
