// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/Result.h>

namespace simulation
{

/// Returns the text of the parameter of this name (without `$`), or nothing when there is no such parameter.
using ParameterLookup = std::function<std::optional<std::string>(std::string_view name)>;

/// Reads a finite number in plain or exponent form with optional blanks around it. Returns nothing for other
/// text, infinities and NaN.
std::optional<double> parseNumber(std::string_view text);

/// Writes the shortest text that parseNumber() reads back as the same value.
std::string formatNumber(double value);

/// Computes the inside of `${…}`: numbers, `$parameters`, true and false, + - * / %, parentheses, unary
/// minus, and, or, not, round, floor, ceil, sqrt, pow(a, b), abs, min(a, b), max(a, b), sign, pi; beyond the
/// standard sin, cos, tan, asin, acos, atan (radians), exp, log. True is 1 and false is 0.
/// Errors: Error.what names the fault and the character; division by zero, results that are not finite, and
/// more than 64 nested levels are errors too. Cost: linear.
/// Source: ASAM, *OpenSCENARIO XML* 1.3, "Expressions".
foundation::Result<double> evaluateExpression(std::string_view text, const ParameterLookup& lookup);

} // namespace simulation
