// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include <foundation/WholeFile.h>

#include <osgMultiTriangulation/core/jobs/BuildFolder.h>

#include "../file/BuildIdentity.h"
#include "../file/PartStore.h"
#include "../file/StoredBuild.h"
#include "../spool/MemoryPlan.h"
#include "../spool/SpoolSource.h"
#include "BuildManifest.h"

namespace osgMultiTriangulation::core
{

struct BuildFolder::Content
{
    Content(const std::filesystem::path& where, BuildManifest read, SurfaceSpool points, PartStore parts)
        : folder(where),
          manifest(std::move(read)),
          order(jobOrder(manifest.partition)),
          spool(std::move(points)),
          store(std::move(parts))
    {
    }

    StoredBuild build() const
    {
        return {*source, manifest.partition, store, manifest.heightStep, manifest.mostHidden};
    }

    std::filesystem::path folder;
    BuildManifest manifest;
    JobOrder order;
    SurfaceSpool spool;
    std::unique_ptr<SpoolSource> source; ///< of the spool and the partition here
    PartStore store;
};

namespace
{

std::filesystem::path manifestOf(const std::filesystem::path& folder)
{
    return folder / "manifest";
}

std::filesystem::path partsOf(const std::filesystem::path& folder)
{
    return folder / "parts";
}

/// Moves the files of a surface to where jobs look for them.
foundation::Outcome putInPlace(const std::filesystem::path& folder)
{
    const std::filesystem::path from = folder / "incoming";
    std::error_code code;
    std::filesystem::remove(from / "triangles", code); // they are in the files of the parts
    for (const auto& entry : std::filesystem::directory_iterator(from, code))
        if (!code) std::filesystem::rename(entry.path(), folder / entry.path().filename(), code);
    if (!code) std::filesystem::remove(from, code);
    if (!code) return foundation::success();
    return foundation::Error{folder.string(), "its files cannot be put in place: " + code.message(),
                             "check that it is writable"};
}

bool isPlanned(const std::filesystem::path& folder, const std::string& manifest)
{
    const auto there = readManifest(manifestOf(folder));
    return there && textOf(*there) == manifest && BuildFolder::open(folder);
}

} // namespace

std::filesystem::path BuildFolder::incoming(const std::filesystem::path& folder)
{
    const std::filesystem::path incoming = folder / "incoming";
    std::error_code ignored; // the first file in it tells what is wrong
    std::filesystem::remove_all(incoming, ignored);
    std::filesystem::create_directories(incoming, ignored);
    return incoming;
}

foundation::Outcome BuildFolder::plan(const SurfaceSpool& spool, const PlanFrame& frame,
                                      const ForestOptions& options, double limitMb,
                                      const std::filesystem::path& folder)
{
    const std::uint64_t points = spool.points().size();
    const auto plan = planMemory(spool, options, limitMb);
    if (!plan) return plan.error();
    BuildManifest manifest{
        frame, spool.heightStep(), points, spool.triangles().size(), plan->mostHidden, 0, {}, {}};
    manifest.partition =
        partitionPoints(scanOf(spool), static_cast<double>(points) / plan->treeCount, options.where);
    manifest.identity = identityOf(spool, frame, manifest.partition, plan->mostHidden);
    const auto source = SpoolSource::create(spool, manifest.partition, spool.folder());
    if (!source) return source.error();
    manifest.trianglesOf = (*source)->counts();
    const std::string text = textOf(manifest);
    std::error_code ignored;
    if (isPlanned(folder, text))
    {
        std::filesystem::remove_all(spool.folder(), ignored);
        return foundation::success();
    }
    std::filesystem::remove(manifestOf(folder), ignored);
    if (const auto placed = putInPlace(folder); !placed) return placed;
    if (const auto store = PartStore::open(partsOf(folder), manifest.identity); !store) return store.error();
    return foundation::writeWholeFile(manifestOf(folder), text);
}

foundation::Result<BuildFolder> BuildFolder::open(const std::filesystem::path& folder)
{
    auto manifest = readManifest(manifestOf(folder));
    if (!manifest) return manifest.error();
    auto spool = SurfaceSpool::openPoints(folder, manifest->points);
    if (!spool) return spool.error();
    auto store = PartStore::existing(partsOf(folder), manifest->identity);
    if (!store) return store.error();
    auto content =
        std::make_unique<Content>(folder, std::move(*manifest), std::move(*spool), std::move(*store));
    auto source =
        SpoolSource::open(content->spool, content->manifest.partition, content->manifest.trianglesOf);
    if (!source) return source.error();
    content->source = std::move(*source);
    return BuildFolder(std::move(content));
}

BuildFolder::BuildFolder(std::unique_ptr<Content> content) : _content(std::move(content)) {}
BuildFolder::BuildFolder(BuildFolder&&) noexcept = default;
BuildFolder::~BuildFolder() = default;

const JobOrder& BuildFolder::order() const
{
    return _content->order;
}

std::uint64_t BuildFolder::points() const
{
    return _content->manifest.points;
}

std::uint64_t BuildFolder::triangles() const
{
    return _content->manifest.triangles;
}

PartSchedule BuildFolder::schedule() const
{
    return PartSchedule(_content->manifest.partition, _content->build().resume());
}

foundation::Outcome BuildFolder::doJob(std::uint64_t job) const
{
    const JobOrder& order = _content->order;
    const std::string place = _content->folder.string();
    if (job >= order.partOf.size())
        return foundation::Error{place,
                                 "has jobs 0 to " + std::to_string(order.partOf.size() - 1) + ", not " +
                                     std::to_string(job),
                                 "name one of them"};
    const std::uint32_t part = order.partOf[job];
    StoredBuild build = _content->build();
    if (build.isDone(part)) return foundation::success();
    for (const std::uint32_t half : _content->manifest.partition.parts[part].halves)
    {
        if (half == kNone || build.isDone(half)) continue;
        if (build.isDone(part)) return foundation::success(); // by now, by another process
        const std::string needed = std::to_string(order.jobOf[half]);
        return foundation::Error{
            place, "job " + std::to_string(job) + " needs job " + needed + ", which is not done",
            "do job " + needed + " first"};
    }
    build.build(part);
    if (build.outcome() || build.isDone(part)) // another process may have done it, and taken what it needs
        return foundation::success();
    return build.outcome();
}

foundation::Result<ForestReport> BuildFolder::write(const std::filesystem::path& file) const
{
    StoredBuild build = _content->build();
    const std::vector<bool> isDone = build.resume();
    for (std::uint32_t job = 0; job < isDone.size(); ++job)
        if (!isDone[_content->order.partOf[job]])
            return foundation::Error{_content->folder.string(), "job " + std::to_string(job) + " is not done",
                                     "do it, and those that need it"};
    const BuildManifest& manifest = _content->manifest;
    const MtInfo info{manifest.frame, 0.0, manifest.points, manifest.triangles, {}};
    if (const auto outcome = build.write(info, file); !outcome) return outcome.error();
    return build.report();
}

} // namespace osgMultiTriangulation::core
