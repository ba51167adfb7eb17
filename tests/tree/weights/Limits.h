// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <foundation/Result.h>

/// The limits of the tree's weight, by name: "PART units" and "PART lines" for each of kParts, and
/// "header PREFIX" for each header whose path begins with the prefix and with no longer one.
using Limits = std::map<std::string, long>;

/// Reads lines of a name and a number; what follows # is a comment.
/// Errors: the file is not there, a line is neither, a name stands twice.
foundation::Result<Limits> readLimits(const std::filesystem::path& file);

/// The name of the limit that binds a header; empty if none does.
std::string headerLimit(const Limits& limits, const std::string& header);

/// What a later list of limits allows and an earlier one did not, a line for each: a higher number, a limit
/// that is gone or exempts headers.
std::vector<std::string> raised(const Limits& before, const Limits& after);
