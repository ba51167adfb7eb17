// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace simulation
{

enum class Rule
{
    equalTo,
    greaterThan,
    lessThan,
    greaterOrEqual,
    lessOrEqual,
    notEqualTo,
};

/// Whether `left rule right` is true.
constexpr bool holds(double left, Rule rule, double right)
{
    switch (rule)
    {
    case Rule::equalTo:
        return left == right;
    case Rule::greaterThan:
        return left > right;
    case Rule::lessThan:
        return left < right;
    case Rule::greaterOrEqual:
        return left >= right;
    case Rule::lessOrEqual:
        return left <= right;
    case Rule::notEqualTo:
        return left != right;
    }
    return false;
}

} // namespace simulation
