// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <vector>

#include <foundation/Threads.h>

#include <osgMultiTriangulation/core/split/BuildForest.h>

namespace osgMultiTriangulation::core
{

/// Hands out parts to threads, halves before the parts that join them.
class JobQueue
{
public:
    /// `isDone`: by part: needs no work; those below it are not asked for either. Empty: none.
    JobQueue(const Partition& partition, const ForestOptions& options, const std::vector<bool>& isDone = {})
        : _partition(partition), _options(options), _missing(partition.parts.size(), 0)
    {
        for (std::uint32_t p = static_cast<std::uint32_t>(partition.parts.size()); p-- > 0;)
        {
            const PlanPart& part = partition.parts[p];
            if (!isDone.empty() && isDone[p])
            {
                ++_done;
                continue;
            }
            for (const std::uint32_t half : part.halves)
                if (half != kNone && (isDone.empty() || !isDone[half])) ++_missing[p];
            if (_missing[p] == 0) _ready.push_back(p);
        }
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

    const Partition& _partition;
    const ForestOptions& _options;
    std::mutex _mutex;
    std::condition_variable _changed;
    std::vector<std::uint32_t> _missing; ///< by part: halves that are not built
    std::vector<std::uint32_t> _ready;
    std::uint32_t _done = 0;
    bool _isStopped = false;
};

Partition partitionFor(const SurfaceMesh& mesh, const ForestOptions& options);

ForestReport reportOf(const Partition& partition, const std::vector<std::uint32_t>& locked,
                      std::uint32_t mainPart);

} // namespace osgMultiTriangulation::core
