// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace terminal
{

/// The progress of long work: what is done, how long it took, and about how long the rest will take. It is
/// quiet for the first two seconds. On a terminal it is one line that is redrawn; elsewhere a line at every
/// tenth, and at the begin of each step.
/// Threads: one tells it; it draws in another one.
class Progress
{
public:
    /// `total`: of parts, or of the shares of steps; 0: unknown, so it counts.
    Progress(std::string label, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more part is done.
    void advance();

    /// A step begins that takes `shares` of the total; the one before it is done.
    void begin(const std::string& step, std::size_t shares);

private:
    class Line;
    std::unique_ptr<Line> _line;
};

/// The text of a progress. Units: seconds.
struct ProgressText
{
    std::string label, step; ///< no step: parts are counted
    std::size_t done = 0, total = 0;
    double pastS = 0.0;

    /// "frames: 12/240, 4 s, about 76 s left", or "worldtool: streets, 40 % done, 20 s, about 30 s left".
    std::string text() const;
};

} // namespace terminal
