// SPDX-License-Identifier: Apache-2.0
// The page of qualities tells what the code's list says.
#include <cmath>
#include <functional>
#include <sstream>

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "scenery/nodes/GroundCoverNode.h"
#include "view/Quality.h"

namespace
{

using trainer::Quality;
using trainer::QualityRules;

std::string percentOrAll(double share)
{
    return share == 1.0 ? "all" : std::to_string(std::lround(100.0 * share)) + " %";
}

std::string number(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string reachesOf(const QualityRules& rules)
{
    std::string text;
    for (const double reachM : rules.shadows.reachesM)
        text += (text.empty() ? "" : ", ") + number(reachM);
    return text + " m";
}

std::string movingMapsOf(const QualityRules& rules)
{
    const std::array<std::string, 5> words{"none", "the nearest", "the two nearest", "the three nearest",
                                           "all"};
    return words[static_cast<std::size_t>(rules.shadows.movingMaps)];
}

std::string coverOf(const QualityRules& rules)
{
    if (rules.coverReaches == 0) return "none";
    return "to " + number(scenery::kCoverReachesM[static_cast<std::size_t>(rules.coverReaches) - 1]) + " m";
}

/// A row of the page, and what its cells say of a quality.
struct Row
{
    std::string begin;
    std::function<std::string(const QualityRules&)> cell;
};

const std::vector<Row> kRows = {
    {"pixels drawn along each side", [](const QualityRules& rules) { return percentOrAll(rules.drawnSide); }},
    {"error of terrain, roads", [](const QualityRules& rules) { return number(rules.tolerancePx) + " px"; }},
    {"triangles of trees", [](const QualityRules& rules) { return percentOrAll(rules.budgetShare); }},
    {"shadow maps: texels", [](const QualityRules& rules) { return std::to_string(rules.shadows.texels); }},
    {"they reach", reachesOf},
    {"of them show vehicles", movingMapsOf},
    {"edge of a shadow", [](const QualityRules& rules)
     { return std::string(rules.shadows.isSoft ? "two texels" : "one texel"); }},
    {"ground below trees",
     [](const QualityRules& rules) { return std::string(rules.hasSkyShade ? "yes" : "no; whole cards"); }},
    {"grass, herbs", coverOf}};

/// The rows that the page lacks or tells otherwise.
std::vector<std::string> wrongRows(const std::string& page)
{
    std::vector<std::string> wrong;
    for (const Row& row : kRows)
    {
        std::string cells;
        for (const Quality quality : {Quality::low, Quality::medium, Quality::high})
            cells += " | " + row.cell(trainer::rulesOf(quality));
        const std::size_t begin = page.find("\n| " + row.begin);
        const std::string line =
            begin == std::string::npos ? "" : page.substr(begin + 1, page.find('\n', begin + 1) - begin - 1);
        if (!line.ends_with(cells + " |")) wrong.push_back(row.begin + cells + ", the page: " + line);
    }
    return wrong;
}

TEST(QualityPage, TellsWhatTheCodeLeavesOut)
{
    const std::string page = testsupport::bytesOf(OSGTRAINER_SOURCE_DIR "/docs/reference/quality.md");
    EXPECT_EQ(wrongRows(page), std::vector<std::string>());
}

TEST(QualityPage, IsFoundWrongWhereANumberDiffers)
{
    std::string page = testsupport::bytesOf(OSGTRAINER_SOURCE_DIR "/docs/reference/quality.md");
    const std::size_t reach = page.find("15, 60, 240, 2000 m");
    ASSERT_NE(reach, std::string::npos);
    page.replace(reach, 2, "16");
    EXPECT_EQ(wrongRows(page).size(), 1U);
}

} // namespace
