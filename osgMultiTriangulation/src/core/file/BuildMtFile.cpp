// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>

#include "../split/JobQueue.h"
#include "../split/MeshSource.h"
#include "../spool/MemoryPlan.h"
#include "../spool/SpoolSource.h"
#include "BuildIdentity.h"
#include "PartStore.h"
#include "StoredBuild.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Builds all parts that are not in the store, writes the file, and removes the store.
foundation::Result<ForestReport> buildParts(StoredBuild& build, const Partition& partition,
                                            const PartStore& store, const ForestOptions& options,
                                            const MtInfo& info, const std::filesystem::path& file)
{
    const std::vector<bool> isDone = build.resume();
    ForestOptions watched = options;
    watched.progress = [&](std::uint32_t done, std::uint32_t all)
    { return build.outcome() && (!options.progress || options.progress(done, all)); };
    JobQueue queue(partition, watched, isDone);
    queue.run([&](std::uint32_t part) { build.build(part); });
    if (const auto outcome = build.outcome(); !outcome) return outcome.error();
    if (queue.isStopped())
        return foundation::Error{file.string(), "the build was stopped", "start it again to go on"};
    if (const auto outcome = build.write(info, file); !outcome) return outcome.error();
    store.remove();
    return build.report();
}

std::filesystem::path beside(const std::filesystem::path& file, const char* ending)
{
    std::filesystem::path folder = file;
    return folder += ending;
}

} // namespace

foundation::Result<ForestReport> buildMtFile(const SurfaceMesh& mesh, const PlanFrame& frame,
                                             const ForestOptions& options, const std::filesystem::path& file)
{
    const Partition partition = partitionFor(mesh, options);
    const auto store = PartStore::open(beside(file, ".parts"), identityOf(mesh, frame, partition));
    if (!store) return store.error();
    const MeshSource source(mesh, partition);
    StoredBuild build(source, partition, *store, commonHeightStep(mesh.points),
                      std::numeric_limits<std::uint64_t>::max());
    const MtInfo info{frame, 0.0, mesh.points.size(), mesh.triangles.size(), {}};
    return buildParts(build, partition, *store, options, info, file);
}

foundation::Result<ForestReport> buildMtFile(const SurfaceSpool& spool, const PlanFrame& frame,
                                             const ForestOptions& options, double limitMb,
                                             const std::filesystem::path& file)
{
    const std::uint64_t points = spool.points().size();
    const auto plan = planMemory(spool, options, limitMb);
    if (!plan) return plan.error();
    const Partition partition =
        partitionPoints(scanOf(spool), static_cast<double>(points) / plan->treeCount, options.where);
    const auto store =
        PartStore::open(beside(file, ".parts"), identityOf(spool, frame, partition, plan->mostHidden));
    if (!store) return store.error();
    const auto source = SpoolSource::create(spool, partition, spool.folder());
    if (!source) return source.error();
    StoredBuild build(**source, partition, *store, spool.heightStep(), plan->mostHidden);
    ForestOptions within = options;
    within.jobs = plan->jobs;
    const MtInfo info{frame, 0.0, points, spool.triangles().size(), {}};
    return buildParts(build, partition, *store, within, info, file);
}

} // namespace osgMultiTriangulation::core
