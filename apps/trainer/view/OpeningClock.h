// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
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
    }

    /// Begins anew, for another play with the same request.
    void restart() { *this = OpeningClock(); }

    const std::vector<OpeningStage>& stages() const { return _stages; }

private:
    struct Moment
    {
        std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
        double processorMs = measurement::processorMs();
    };

    Moment _last;
    std::vector<OpeningStage> _stages;
};

} // namespace trainer
