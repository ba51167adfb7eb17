// SPDX-License-Identifier: Apache-2.0
// What the parts of a picture cost: the difference of medians.
#include "view/PartsTable.h"

#include <gtest/gtest.h>

namespace
{

std::vector<trainer::PartCosts> costs()
{
    return {{"", {{40.0, 100.0, 9.0}, {41.0, 104.0, 9.0}, {300.0, 900.0, 9.0}}},
            {"sky", {{20.0, 84.0, 8.0, 5.0}, {21.0, 80.0, 8.0, 5.0}, {22.0, 82.0, 8.0, 5.0}}},
            {"never drawn", {}}};
}

} // namespace

TEST(PartsTable, APartCostsWhatPicturesWithoutItTakeLess)
{
    const std::string text = trainer::partsText(costs());
    const auto line = text.substr(text.find("\nsky") + 1);
    EXPECT_NE(line.find(" 82.0 "), std::string::npos) << text; // the median without
    EXPECT_NE(line.find(" 22.0 "), std::string::npos) << text; // 104 - 82: one slow picture does not count
    EXPECT_NE(line.find(" 8        5\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("never"), std::string::npos);
}
