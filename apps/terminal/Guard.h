// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include <foundation/Result.h>

namespace terminal
{

/// Does the work of a program and returns its exit code. What escapes from the work becomes one line on
/// stderr and kFailed: memory that could not be had, and any other exception, from other threads, too.
/// Libraries that crash where an allocation fails (Mesa, LLVM) end in the same way while a limit of address
/// space is nearly used up; any other crash stays a crash.
int guarded(const std::string& program, const std::function<int()>& work);

/// Returns the error of an allocation that failed, with the memory in use and its limit. `place`: a file, or
/// "memory".
foundation::Error outOfMemory(const std::string& place);

} // namespace terminal
