// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "measurement/ProcessorTime.h"

namespace trainer
{

/// A stage of opening a scene, and what it took.
struct OpeningStage
{
    std::string_view name;
    double wallS = 0.0;      ///< by the clock on the wall
    double processorS = 0.0; ///< of all threads of the process
};

/// Hears how far long work at the opening of a scene is, until it is destroyed.
class OpeningWatch
{
public:
    virtual ~OpeningWatch() = default;

    /// The stage of this name has ended.
    virtual void hasEnded(std::string_view stage) = 0;
};

/// Measures the stages from the start of a play to its first picture: each begins where the one before it
/// ended.
/// Threads: one.
class OpeningClock
{
public:
    /// Ends a stage. `name` must outlive the clock: a literal.
    void end(std::string_view name)
    {
        const Moment now;
        _stages.push_back({name, std::chrono::duration<double>(now.wall - _last.wall).count(),
                           1e-3 * (now.processorMs - _last.processorMs)});
        _last = now;
        if (const auto watch = _watch.lock()) watch->hasEnded(name);
    }

    /// Makes the watch of some work: "opens dem.tif".
    using WatchMaker = std::function<std::shared_ptr<OpeningWatch>(const std::string& work)>;
    void watchBy(WatchMaker make) { _makeWatch = std::move(make); }

    /// Begins work whose stages are watched as long as what is returned lives; null: nobody watches.
    [[nodiscard]] std::shared_ptr<OpeningWatch> watched(const std::string& work)
    {
        const auto watch = _makeWatch ? _makeWatch(work) : nullptr;
        _watch = watch;
        return watch;
    }

    /// Begins anew, for another play with the same request.
    void restart()
    {
        _last = Moment();
        _stages.clear();
    }

    const std::vector<OpeningStage>& stages() const { return _stages; }

private:
    struct Moment
    {
        std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
        double processorMs = measurement::processorMs();
    };

    Moment _last;
    std::vector<OpeningStage> _stages;
    WatchMaker _makeWatch;
    std::weak_ptr<OpeningWatch> _watch;
};

} // namespace trainer
