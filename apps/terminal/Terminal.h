// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <foundation/Result.h>

namespace terminal
{

/// Exit codes of every program: the work failed, or it was asked for in a way that makes no sense.
enum ExitCode
{
    kDone = 0,
    kFailed = 1,
    kWrongUse = 2,
};

/// Prints "program: place: what; remedy" on stderr, one line whatever a file is called, and returns kFailed.
int fail(const std::string& program, const foundation::Error& error);

/// Progress of a long piece of work: a bar that redraws itself on a terminal, a plain line at every tenth elsewhere.
/// `total` 0: not known; then it counts.
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
