// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

namespace trainer
{

/// A line of a text file: its cells, parted by blanks and tabs, without what stands after #.
struct TextLine
{
    std::vector<std::string_view> cells; ///< at least one
    std::string place;                   ///< file:line
};

/// Gives every line that is not empty to `take`, after it has seen `first` as the first of them. Ends with
/// the first error.
/// Errors: another first line, no line, those of `take`.
foundation::Outcome readLines(std::string_view text, const std::string& name, std::string_view first,
                              const std::function<foundation::Outcome(const TextLine&)>& take);

/// A number within limits, or nothing.
std::optional<double> numberIn(std::string_view cell, double least, double most);

} // namespace trainer
