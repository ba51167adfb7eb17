// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <iconv.h>

namespace foundation
{

/// Returns the name of the encoding of a text in UTF-16 or UTF-32, by its byte order mark or by the zeros
/// around its first `<`; nothing: it is neither.
/// Source: W3C, *Extensible Markup Language (XML) 1.0*, 5th edition, appendix F (detection of character
/// encodings).
inline std::optional<const char*> wideEncodingOf(std::string_view text)
{
    const auto startsWith = [&](std::string_view mark) { return text.substr(0, mark.size()) == mark; };
    // The marks of UTF-32 begin as those of UTF-16 do, or hold them.
    if (startsWith(std::string_view("\xFF\xFE\0\0", 4)) || startsWith(std::string_view("\0\0\xFE\xFF", 4)))
        return "UTF-32";
    if (startsWith("\xFE\xFF") || startsWith("\xFF\xFE")) return "UTF-16";
    if (startsWith(std::string_view("<\0\0\0", 4))) return "UTF-32LE";
    if (startsWith(std::string_view("\0\0\0<", 4))) return "UTF-32BE";
    if (startsWith(std::string_view("<\0", 2))) return "UTF-16LE";
    if (startsWith(std::string_view("\0<", 2))) return "UTF-16BE";
    return std::nullopt;
}

/// Converts a text to UTF-8, a byte order mark left out. `encoding`: as iconv names it. Returns nothing where
/// the text is not valid in it.
inline std::optional<std::string> toUtf8(std::string_view text, const char* encoding)
{
    const iconv_t converter = iconv_open("UTF-8", encoding);
    if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
    std::string result;
    std::string input(text);
    char* from = input.data();
    std::size_t left = input.size();
    bool isSound = true;
    while (left > 0 && isSound)
    {
        char buffer[4096];
        char* to = buffer;
        std::size_t room = sizeof buffer;
        const std::size_t before = left;
        iconv(converter, &from, &left, &to, &room);
        result.append(buffer, to);
        isSound = left < before; // stuck: a sequence that is wrong or cut off
    }
    iconv_close(converter);
    if (!isSound) return std::nullopt;
    return result;
}

} // namespace foundation
