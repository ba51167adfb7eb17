// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "MarkdownTable.h"

namespace reference
{

/// The string literals among the arguments of every call `function(…)` in a source text, in order.
std::vector<std::vector<std::string>> literalsOfCalls(std::string_view source, const std::string& function);

/// All of them for several functions; `firstOnly`: the first of each call alone.
Names literalsOfCalls(std::string_view source, const std::vector<std::string>& functions, bool firstOnly);

/// The string literals that begin with a text, from the first time that `name` stands in a source text to the
/// end of that statement.
Names literalsOfStatement(std::string_view source, std::string_view name, std::string_view beginning = {});

} // namespace reference
