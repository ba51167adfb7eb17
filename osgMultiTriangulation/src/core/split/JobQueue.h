// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <vector>

#include <foundation/Threads.h>

#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgMultiTriangulation/core/split/PartSchedule.h>

namespace osgMultiTriangulation::core
{

/// Hands out parts to threads, halves before the parts that join them.
class JobQueue
{
public:
    /// `isDone`: by part: needs no work; those below it are not asked for either. Empty: none.
    JobQueue(const Partition& partition, const ForestOptions& options, const std::vector<bool>& isDone = {})
        : _schedule(partition, isDone), _options(options)
    {
    }

    /// Does `work(part)` for all parts, in as many threads as the options say. Errors: what a thread throws.
    template<class Work>
    void run(const Work& work)
    {
        foundation::Threads others;
        for (unsigned job = 1; job < _options.jobs; ++job)
            others.run([&] { runOne(work); });
        runOne(work);
        others.join();
    }

    /// Waits for a part that can be built. Returns kNone when there will be none.
    std::uint32_t take()
    {
        std::unique_lock lock(_mutex);
        _changed.wait(lock, [this] { return _schedule.hasReady() || _isStopped || _schedule.isFinished(); });
        return _isStopped ? kNone : _schedule.take();
    }

    void finish(std::uint32_t part)
    {
        const std::lock_guard lock(_mutex);
        _schedule.finish(part);
        if (_options.progress && !_options.progress(_schedule.done(), _schedule.all())) _isStopped = true;
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
    template<class Work>
    void runOne(const Work& work)
    {
        for (std::uint32_t part = take(); part != kNone; part = take())
        {
            try
            {
                work(part);
            }
            catch (...)
            {
                stop();
                throw;
            }
            finish(part);
        }
    }

    PartSchedule _schedule;
    const ForestOptions& _options;
    std::mutex _mutex;
    std::condition_variable _changed;
    bool _isStopped = false;
};

Partition partitionFor(const SurfaceMesh& mesh, const ForestOptions& options);

ForestReport reportOf(const Partition& partition, const std::vector<std::uint32_t>& locked,
                      std::uint32_t mainPart);

} // namespace osgMultiTriangulation::core
