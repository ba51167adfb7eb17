// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

namespace trainer
{

/// Runs a program to its end, and returns its exit code; 128 and the number of the signal that ended it. What
/// it says on stderr is shown, what it says on stdout is not. While it runs, no other runs under the same
/// lock (a file, which is made): another waits for it.
/// Errors: the lock cannot be had; the program cannot be begun.
foundation::Result<int> runProgram(const std::vector<std::string>& words, const std::filesystem::path& lock);

} // namespace trainer
