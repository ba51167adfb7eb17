// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace foundation
{

/// Returns a text whole, or, where it has more than `mostBytes`, its beginning and its end with the number of
/// bytes left out between them: a message stays readable when a file has a line of 100 kB. No character of
/// UTF-8 is cut in two.
inline std::string excerpt(std::string_view text, std::size_t mostBytes = 300)
{
    if (text.size() <= mostBytes) return std::string(text);
    const auto isInsideCharacter = [&](std::size_t at)
    { return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };
    std::size_t first = 2 * mostBytes / 3, last = text.size() - mostBytes / 3;
    while (first > 0 && isInsideCharacter(first))
        --first;
    while (isInsideCharacter(last))
        ++last;
    return std::string(text.substr(0, first)) + " … (" + std::to_string(last - first) +
           " bytes left out) … " + std::string(text.substr(last));
}

} // namespace foundation
