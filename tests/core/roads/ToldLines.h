// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgRoads/core/check/NetworkCheck.h>

#include "RoadTexts.h"

namespace roadtexts
{

/// A message names the file, the line, what is wrong and the remedy, on one line.
inline constexpr const char* kMessage = "a\\.xodr:[0-9]+: [^\n]+; [^\n]+";

/// Everything that is told about a text: the error, or the problems and the flaws. A failed test where a
/// message lacks a part.
inline std::vector<std::string> told(const std::string& text)
{
    using namespace osgRoads::core;
    std::vector<std::string> lines;
    if (const auto read = parseNetwork(text, "a.xodr"))
    {
        for (const Problem& problem : read->problems)
            lines.push_back(problem.message("a.xodr"));
        for (const Flaw& flaw : checkNetwork(read->network).flaws)
            lines.push_back(flaw.message("a.xodr"));
    }
    else
        lines.push_back(read.error().message());
    EXPECT_THAT(lines, testing::Each(testing::MatchesRegex(kMessage)));
    return lines;
}

inline std::string plainRoad(const std::string& id)
{
    return road(id, 50.0, straightPlan(50.0) + twoLanes());
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

} // namespace roadtexts
