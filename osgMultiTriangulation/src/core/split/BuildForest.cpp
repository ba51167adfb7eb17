// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>

#include <foundation/Threads.h>

#include <osgMultiTriangulation/core/split/BuildForest.h>

#include "PartJobs.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Hands out parts to threads, halves before the parts that join them.
class JobQueue
{
public:
    JobQueue(const Partition& partition, const ForestOptions& options)
        : _partition(partition), _options(options), _missing(partition.parts.size(), 0)
    {
        for (std::uint32_t p = static_cast<std::uint32_t>(partition.parts.size()); p-- > 0;)
        {
            if (partition.parts[p].isWhole())
                _ready.push_back(p);
            else
                _missing[p] = 2;
        }
    }

    /// Waits for a part that can be built. Returns kNone when there will be none.
    std::uint32_t take()
    {
        std::unique_lock lock(_mutex);
        _changed.wait(lock, [this] { return !_ready.empty() || _isStopped || _done == _missing.size(); });
        if (_ready.empty() || _isStopped) return kNone;
        const std::uint32_t part = _ready.back();
        _ready.pop_back();
        return part;
    }

    void finish(std::uint32_t part)
    {
        const std::lock_guard lock(_mutex);
        ++_done;
        const std::uint32_t parent = _partition.parts[part].parent;
        if (parent != kNone && --_missing[parent] == 0) _ready.push_back(parent);
        if (_options.progress && !_options.progress(_done, static_cast<std::uint32_t>(_missing.size())))
            _isStopped = true;
        _changed.notify_all();
    }

    /// After an exception of a thread: the others end.
    void stop()
    {
        const std::lock_guard lock(_mutex);
        _isStopped = true;
        _changed.notify_all();
    }

    bool isStopped() const { return _isStopped; }

private:
    const Partition& _partition;
    const ForestOptions& _options;
    std::mutex _mutex;
    std::condition_variable _changed;
    std::vector<std::uint32_t> _missing; ///< by part: halves that are not built
    std::vector<std::uint32_t> _ready;
    std::uint32_t _done = 0;
    bool _isStopped = false;
};

void work(JobQueue& queue, PartJobs& jobs)
{
    for (std::uint32_t part = queue.take(); part != kNone; part = queue.take())
    {
        try
        {
            jobs.build(part);
        }
        catch (...)
        {
            queue.stop();
            throw;
        }
        queue.finish(part);
    }
}

ForestReport reportOf(const Partition& partition, const PartJobs& jobs, const Forest& forest)
{
    ForestReport report;
    report.rectangles = partition.rectangles;
    report.mainPart = static_cast<std::uint32_t>(forest.trees[0].part.points.size());
    report.smallestTree = kNone;
    for (std::uint32_t p = 0; p < partition.parts.size(); ++p)
    {
        if (!partition.parts[p].isWhole()) continue;
        report.largestTree = std::max(report.largestTree, partition.parts[p].points);
        report.smallestTree = std::min(report.smallestTree, partition.parts[p].points);
        report.borderPoints += static_cast<double>(jobs.lockedIn(p)) / partition.rectangles;
    }
    return report;
}

} // namespace

foundation::Result<BuiltForest> buildForest(const SurfaceMesh& mesh, const ForestOptions& options)
{
    const auto points = static_cast<double>(mesh.points.size());
    const std::uint32_t count =
        options.treeCount > 0 ? options.treeCount : balancedTreeCount(points, options.border);
    const Partition partition = partitionPoints(mesh.points, points / count, options.where);
    PartJobs jobs(mesh, partition);
    JobQueue queue(partition, options);
    foundation::Threads others;
    for (unsigned job = 1; job < options.jobs; ++job)
        others.run([&] { work(queue, jobs); });
    work(queue, jobs);
    others.join();
    if (queue.isStopped()) return foundation::Error{"the build", "was stopped", "start it again"};
    BuiltForest built;
    built.forest = jobs.takeForest();
    built.report = reportOf(partition, jobs, built.forest);
    return built;
}

} // namespace osgMultiTriangulation::core
