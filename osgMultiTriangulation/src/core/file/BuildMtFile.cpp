// SPDX-License-Identifier: Apache-2.0
#include <mutex>
#include <string>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>

#include "../split/JobQueue.h"
#include "MtHeader.h"
#include "PartStore.h"

namespace osgMultiTriangulation::core
{

namespace
{

template<class T>
std::uint32_t sumOf(const std::vector<T>& list)
{
    return mtChecksum({reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)});
}

/// A sum over all on which the bytes of the parts depend.
std::uint32_t identityOf(const SurfaceMesh& mesh, const PlanFrame& frame, const Partition& partition)
{
    std::uint32_t points = 0;
    for (const SurfacePoint& p :
         mesh.points) // field by field: there are bytes between them that nobody wrote
    {
        std::string bytes;
        LittleEndian out(bytes);
        out.add(p.x);
        out.add(p.y);
        out.add(p.height);
        points = points * 31 + mtChecksum(bytes);
    }
    std::string all;
    LittleEndian out(all);
    for (const std::uint32_t sum : {points, sumOf(mesh.triangles), sumOf(partition.partOf), kMtVersion})
        out.add(sum);
    for (const double value : {frame.originX, frame.originY, frame.stepX, frame.stepY})
        out.add(value);
    return mtChecksum(all);
}

/// A build whose parts are kept in a folder.
class StoredBuild
{
public:
    StoredBuild(const SurfaceMesh& mesh, const Partition& partition, const PartStore& store)
        : _partition(partition),
          _store(store),
          _jobs(mesh, partition),
          _heightStep(commonHeightStep(mesh.points)),
          _entries(partition.parts.size()),
          _locked(partition.parts.size())
    {
    }

    /// Takes what an earlier run has finished. Returns by part whether it needs no work.
    std::vector<bool> resume()
    {
        std::vector<bool> isDone(_partition.parts.size(), false);
        for (std::uint32_t part = 0; part < isDone.size(); ++part)
        {
            const std::uint32_t parent = _partition.parts[part].parent;
            const auto tree = _store.tree(part);
            if (!tree) continue;
            if (parent != kNone && !isDone[parent])
            {
                auto rest = _store.rest(part);
                if (!rest) continue;
                _jobs.restore(part, std::move(*rest));
            }
            isDone[part] = true;
            keep(part, *tree);
        }
        return isDone;
    }

    void build(std::uint32_t part)
    {
        const TreeRecord record = _jobs.build(part);
        const StoredTree tree{encodedTree(record, _partition.parts[part].parent, _heightStep),
                              _jobs.lockedIn(part)};
        if (part != 0) note(_store.putRest(part, _jobs.restOf(part)));
        note(_store.putTree(part, tree));
        keep(part, tree);
        for (const std::uint32_t half : _partition.parts[part].halves)
            if (half != kNone) _store.dropRest(half);
    }

    foundation::Outcome outcome() const { return _outcome; }
    bool hasFailed() const { return !_outcome; }

    foundation::Outcome write(MtInfo info, const std::filesystem::path& file) const
    {
        info.heightStep = _heightStep;
        return writeMtFile(file, info, _entries,
                           [this, &file](std::uint32_t part) -> foundation::Result<std::vector<std::byte>>
                           {
                               auto tree = _store.tree(part);
                               if (tree) return std::move(tree->encoded.bytes);
                               return foundation::Error{file.string(), "a finished part has disappeared",
                                                        "start the build again"};
                           });
    }

    ForestReport report() const { return reportOf(_partition, _locked, _entries[0].points); }

private:
    void keep(std::uint32_t part, const StoredTree& tree)
    {
        _entries[part] = tree.encoded.entry;
        _locked[part] = tree.locked;
    }

    void note(const foundation::Outcome& outcome)
    {
        const std::lock_guard lock(_mutex);
        if (!outcome) _outcome = outcome;
    }

    const Partition& _partition;
    const PartStore& _store;
    PartJobs _jobs;
    double _heightStep;
    std::vector<MtEntry> _entries;
    std::vector<std::uint32_t> _locked;
    std::mutex _mutex;
    foundation::Outcome _outcome = foundation::success();
};

} // namespace

foundation::Result<ForestReport> buildMtFile(const SurfaceMesh& mesh, const PlanFrame& frame,
                                             const ForestOptions& options, const std::filesystem::path& file)
{
    const Partition partition = partitionFor(mesh, options);
    std::filesystem::path folder = file;
    folder += ".parts";
    const auto store = PartStore::open(folder, identityOf(mesh, frame, partition));
    if (!store) return store.error();
    StoredBuild build(mesh, partition, *store);
    const std::vector<bool> isDone = build.resume();
    ForestOptions watched = options;
    watched.progress = [&](std::uint32_t done, std::uint32_t all)
    { return !build.hasFailed() && (!options.progress || options.progress(done, all)); };
    JobQueue queue(partition, watched, isDone);
    queue.run([&](std::uint32_t part) { build.build(part); });
    if (const auto outcome = build.outcome(); !outcome) return outcome.error();
    if (queue.isStopped())
        return foundation::Error{file.string(), "the build was stopped", "start it again to go on"};
    MtInfo info;
    info.frame = frame;
    info.points = mesh.points.size();
    info.triangles = mesh.triangles.size();
    if (const auto outcome = build.write(info, file); !outcome) return outcome.error();
    store->remove();
    return build.report();
}

} // namespace osgMultiTriangulation::core
