// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/Result.h>

namespace simulation
{

/// Text of a parameter by its name without `$`; nothing when there is none.
using ParameterLookup = std::function<std::optional<std::string>(std::string_view name)>;

/// A finite number in plain or exponent form, with nothing but blanks around it; nothing for other text,
/// infinities and NaN included.
std::optional<double> parseNumber(std::string_view text);

/// Shortest text that parseNumber() reads back to the same value.
std::string formatNumber(double value);

/// The inside of `${…}`: numbers, `$parameters`, true and false, + - * / %, parentheses, unary minus, and,
/// or, not, round, floor, ceil, sqrt, pow(a, b), abs, min(a, b), max(a, b), sign. Truth is 1 and 0. Errors:
/// Error.what says what and at which character; also division by zero and results that are not finite. Cost:
/// linear; nesting deeper than 64 is an error. Source: ASAM OpenSCENARIO XML 1.3, "Expressions".
foundation::Result<double> evaluateExpression(std::string_view text, const ParameterLookup& lookup);

} // namespace simulation
