// SPDX-License-Identifier: Apache-2.0
#include "OpeningProgress.h"

#include <array>
#include <cstddef>

#include <unistd.h>

#include "terminal/Progress.h"

namespace trainer
{

namespace
{

/// A stage, and which share of the whole opening it takes: the default world, opened again.
struct StageShare
{
    std::string_view ended, next;
    std::size_t shares; ///< of `next`
};

constexpr std::array<StageShare, 7> kStages = {{{"program", "ground", 30},
                                                {"ground", "land", 25},
                                                {"land", "what stands on it", 45},
                                                {"what stands on it", "", 0},
                                                {"scenario", "scenery", 40},
                                                {"scenery", "entities", 40},
                                                {"entities", "cover", 20}}};
constexpr std::size_t kAllShares = 100;

class OpeningProgress final : public OpeningWatch
{
public:
    explicit OpeningProgress(const std::string& work) : _progress("trainer " + work, kAllShares) {}

    void hasEnded(std::string_view stage) override
    {
        if (!_isOnTerminal) return; // lines of a log would stand among those of errors
        for (const StageShare& share : kStages)
            if (share.ended == stage && share.shares > 0)
                _progress.begin(std::string(share.next), share.shares);
    }

private:
    bool _isOnTerminal = isatty(STDERR_FILENO) != 0;
    terminal::Progress _progress;
};

} // namespace

std::shared_ptr<OpeningWatch> showOpening(const std::string& work)
{
    return std::make_shared<OpeningProgress>(work);
}

} // namespace trainer
