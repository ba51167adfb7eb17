// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>

namespace terraintool
{

/// What a command has used.
struct ShellRun
{
    double processorS = 0.0; ///< of it and its children
};

/// Runs a command of the shell with further arguments, which the shell does not look into, to its end. What
/// it says on stdout is shown on stderr.
/// Errors: it cannot be begun, or returns another code than 0.
foundation::Result<ShellRun> runInShell(const std::string& command,
                                        const std::vector<std::string>& arguments);

} // namespace terraintool
