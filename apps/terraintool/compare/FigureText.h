// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

namespace terraintool
{

/// A figure with four digits that count; 1000 and more as a whole number.
template<class Number>
std::string number(Number value)
{
    char text[48];
    std::snprintf(text, sizeof text, value < 1000 ? "%.4g" : "%.0f", static_cast<double>(value));
    return text;
}

} // namespace terraintool
