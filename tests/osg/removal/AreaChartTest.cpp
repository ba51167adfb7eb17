// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/AreaChart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

using pmtool::areaChart;
using testing::HasSubstr;
using testing::Not;

std::size_t countOf(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(AreaChart, EveryLineOfEveryPanelIsDrawn)
{
    const std::string svg = areaChart({{"ball", {{"1 a", {{1.0, 1.0}, {0.5, 0.9}}}, {"2 b", {{1.0, 1.0}}}}},
                                       {"cube", {{"1 a", {{1.0, 1.0}, {0.1, 0.4}}}}},
                                       {"cone", {}}});
    EXPECT_EQ(countOf(svg, "<polyline"), 3u);
    EXPECT_EQ(countOf(svg, "<g "), 3u);
    EXPECT_THAT(svg, HasSubstr("height=\"480\"")) << "two rows";
    EXPECT_EQ(countOf(svg, "<g "), countOf(svg, "</g>"));
}

TEST(AreaChart, AllFacesAreAtTheRightAndAHundredthAtTheLeft)
{
    const std::string svg = areaChart({{"", {{"", {{1.0, 1.0}, {0.1, 0.8}, {0.01, 0.6}, {0.001, 0.1}}}}}});
    EXPECT_THAT(svg, HasSubstr("points=\"402.0,28.0 225.0,118.0 48.0,208.0 \""))
        << "a thousandth is beyond the border, and does not widen the range of areas";
}

TEST(AreaChart, NamesAreNoMarkup)
{
    const std::string svg = areaChart({{"a<b>&c", {}}});
    EXPECT_THAT(svg, HasSubstr("a&lt;b>&amp;c"));
    EXPECT_THAT(svg, Not(HasSubstr("a<b")));
}

} // namespace
