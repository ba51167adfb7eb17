// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <foundation/Result.h>

namespace terminal
{

/// The exit codes of all programs: success, failed work, wrong use.
enum ExitCode
{
    kDone = 0,
    kFailed = 1,
    kWrongUse = 2,
};

/// Prints "program: place: what; remedy" as one line on stderr and returns kFailed.
int fail(const std::string& program, const foundation::Error& error);

/// The progress of long work: a bar that is redrawn on a terminal, a line at every tenth elsewhere. `total` 0:
/// unknown, so it counts.
class Progress
{
public:
    Progress(std::string label, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void advance();

private:
    void print() const;

    std::string _label;
    std::size_t _total;
    std::size_t _done = 0;
    bool _isTerminal;
};

} // namespace terminal
