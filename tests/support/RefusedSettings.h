// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace testsupport
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Each wrong value of one field has to be refused at "Owner.field".
template<class Settings, class Value>
void expectRefused(const Settings& good, Value Settings::*field, const std::string& place,
                   std::initializer_list<Value> wrong)
{
    EXPECT_TRUE(checkSettings(good)) << place;
    for (const Value& value : wrong)
    {
        Settings settings = good;
        settings.*field = value;
        const auto checked = checkSettings(settings);
        ASSERT_FALSE(checked) << place;
        EXPECT_EQ(checked.error().place, place);
        EXPECT_NE(checked.error().remedy.find("give "), std::string::npos);
    }
}

} // namespace testsupport
