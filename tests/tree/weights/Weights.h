// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <foundation/Result.h>

#include "IncludeGraph.h"

/// What a name weighs: an object or a header, and its lines with all that it includes.
using Weighed = std::pair<std::string, long>;

/// What limits bind the units of: what is behind ./demo, behind ./check, and all that ./check --long builds.
inline constexpr std::array<const char*, 3> kParts{"demo", "check", "all"};

/// The weight of the tree: lines of each unit and of each header.
struct Weights
{
    IncludeGraph graph;
    std::map<std::string, std::vector<Weighed>> units; ///< of each of kParts, heaviest first
    std::vector<Weighed> headers;                      ///< by path below the root, heaviest first

    static long sum(const std::vector<Weighed>& units);
};

/// Weighs a tree by the lists of a folder, which tests/tree/weigh-lists writes: compile_commands.json,
/// NAME.txt for each of kParts (objects), headers.txt, system.txt (the compiler's own include folders),
/// read.txt (all files that the compiler has read). Files of `overlay` stand in for those of `root`.
foundation::Result<Weights> weigh(const std::filesystem::path& lists, const std::filesystem::path& root,
                                  const std::filesystem::path& overlay);
