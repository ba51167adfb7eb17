// SPDX-License-Identifier: Apache-2.0
#pragma once

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

} // namespace terminal
