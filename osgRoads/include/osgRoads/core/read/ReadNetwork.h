// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgRoads/core/read/Problem.h>

namespace osgRoads::core
{

struct ReadOptions
{
    std::size_t maximumBytes = std::size_t{1} << 30;
};

/// A network together with what was wrong or not understood in its file.
struct ReadNetwork
{
    RoadNetwork network;
    std::vector<Problem> problems;     ///< in the order of the file; at most kMostMistakes mistakes
    std::size_t mistakesNotListed = 0; ///< beyond those

    static constexpr std::size_t kMostMistakes = 1000;
};

/// Reads an OpenDRIVE file, version 1.4 to 1.8 (older 1.x as far as it agrees).
/// Errors, as file:line: not a readable file, too large, not XML, nested too deep, no OpenDRIVE, another
/// major version, no road that can be used. Everything else is a problem of the result.
/// Memory: about six times the file while it is read, about three times after.
/// Source: ASAM OpenDRIVE 1.8; 1.4 for crossfall and poly3.
foundation::Result<ReadNetwork> readNetwork(const std::filesystem::path& file,
                                            const ReadOptions& options = {});

/// Reads the text of an OpenDRIVE file. `name`: for errors.
foundation::Result<ReadNetwork> parseNetwork(std::string_view text, const std::string& name);

} // namespace osgRoads::core
