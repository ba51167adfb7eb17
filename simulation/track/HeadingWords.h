// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace simulation
{

/// Returns the words of a column's heading, in small letters without accents: letters in a row; a capital
/// behind a small one begins another. `name`: in UTF-8.
std::vector<std::string> headingWords(std::string_view name);

/// Returns the same words in English where they are German, French, Spanish, Italian, Dutch or Portuguese
/// ones for what tables of positions hold; a compound may become two. Others stay as they are.
std::vector<std::string> inEnglish(const std::vector<std::string>& words);

} // namespace simulation
