// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/Result.h>
#include <iconv.h>

namespace foundation
{

/// Returns the name of the encoding of a text in UTF-16 or UTF-32, by its byte order mark or by the zeros
/// around its first character, which is one of ASCII; nothing: it is neither.
/// Source: W3C, *Extensible Markup Language (XML) 1.0*, 5th edition, appendix F (detection of character
/// encodings).
inline std::optional<const char*> wideEncodingOf(std::string_view text)
{
    const auto startsWith = [&](std::string_view mark) { return text.substr(0, mark.size()) == mark; };
    // The marks of UTF-32 begin as those of UTF-16 do, or hold them.
    if (startsWith(std::string_view("\xFF\xFE\0\0", 4)) || startsWith(std::string_view("\0\0\xFE\xFF", 4)))
        return "UTF-32";
    if (startsWith("\xFE\xFF") || startsWith("\xFF\xFE")) return "UTF-16";
    const auto isAscii = [&](std::size_t at)
    { return at < text.size() && text[at] >= '\t' && text[at] <= '~'; };
    const auto isZero = [&](std::size_t at) { return at < text.size() && text[at] == '\0'; };
    if (isAscii(0) && isZero(1)) return isZero(2) && isZero(3) ? "UTF-32LE" : "UTF-16LE";
    if (isZero(0) && isZero(1) && isZero(2) && isAscii(3)) return "UTF-32BE";
    if (isZero(0) && isAscii(1)) return "UTF-16BE";
    return std::nullopt;
}

/// Converts a text to UTF-8, a byte order mark left out. `encoding`: as iconv names it. Returns nothing where
/// the text is not valid in it; `line`, where given, is then that of the first wrong character, or 0 where
/// there is no such encoding.
inline std::optional<std::string> toUtf8(std::string_view text, const char* encoding, int* line = nullptr)
{
    if (line) *line = 0;
    const iconv_t converter = iconv_open("UTF-8", encoding);             // -1: there is no such encoding
    if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt; // NOLINT(performance-no-int-to-ptr)
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
    if (isSound) return result;
    if (line) *line = 1 + static_cast<int>(std::count(result.begin(), result.end(), '\n'));
    return std::nullopt;
}

/// Returns the number of bytes of the character of UTF-8 at a place of a text; 0: there is none.
/// Source: Unicode 15, table 3-7 (well-formed byte sequences).
inline std::size_t utf8Length(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
    const unsigned char first = byte(0);
    if (first < 0x80U) return 1;
    const std::size_t length = first >= 0xC2U && first <= 0xDFU   ? 2
                               : first >= 0xE0U && first <= 0xEFU ? 3
                               : first >= 0xF0U && first <= 0xF4U ? 4
                                                                  : 0;
    if (length == 0 || at + length > text.size()) return 0;
    const unsigned char least = first == 0xE0U ? 0xA0U : first == 0xF0U ? 0x90U : 0x80U;
    const unsigned char most = first == 0xEDU ? 0x9FU : first == 0xF4U ? 0x8FU : 0xBFU;
    if (byte(1) < least || byte(1) > most) return 0;
    for (std::size_t i = 2; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    return length;
}

/// Returns the beginning of a text in UTF-8, of so many bytes at most, that cuts no character in two.
inline std::string_view utf8Beginning(std::string_view text, std::size_t mostBytes)
{
    if (text.size() <= mostBytes) return text;
    while (mostBytes > 0 && (static_cast<unsigned char>(text[mostBytes]) & 0xC0U) == 0x80U)
        --mostBytes;
    return text.substr(0, mostBytes);
}

/// A text that is read in UTF-8, whatever it was written in.
class Utf8Text
{
public:
    /// Takes a text by its byte order mark, by the zeros of wide characters, else as `encoding` says (as
    /// iconv names it; a name of 8-bit ISO 8859-1 stands for Windows-1252, which has the same letters and
    /// more). `encoding` empty: UTF-8, in which bytes that are none are taken as Windows-1252, one by one.
    /// Errors: `name:1`: no such encoding; `name:line`: not valid in it.
    static Result<Utf8Text> of(std::string_view text, std::string encoding, const std::string& name);

    /// The text without a byte order mark; a view of `original`, that of(), was given, where it was UTF-8.
    std::string_view in(std::string_view original) const
    {
        return _isConverted ? std::string_view(_text) : original.substr(_markBytes);
    }

    /// Bytes that were not UTF-8, and the line of the first.
    std::size_t strayBytes() const { return _strayBytes; }
    int strayLine() const { return _strayLine; }

    /// One sentence about stray bytes.
    std::string strayWords() const
    {
        return (_strayBytes == 1 ? "a byte that is" : std::to_string(_strayBytes) + " bytes that are") +
               std::string(" not UTF-8, taken as Windows-1252");
    }

private:
    void take(std::string text)
    {
        _text = std::move(text);
        _isConverted = true;
    }

    void mend(std::string_view text);

    std::string _text;
    bool _isConverted = false;
    std::size_t _markBytes = 0, _strayBytes = 0;
    int _strayLine = 0;
};

inline Result<Utf8Text> Utf8Text::of(std::string_view text, std::string encoding, const std::string& name)
{
    Utf8Text result;
    for (char& c : encoding)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (const auto wide = wideEncodingOf(text))
        encoding = *wide;
    else if (text.starts_with("\xEF\xBB\xBF"))
    {
        result._markBytes = 3;
        encoding.clear();
    }
    else if (encoding.starts_with("UTF") || encoding.starts_with("UCS") ||
             encoding.starts_with("ISO-10646") || encoding == "US-ASCII" || encoding == "ASCII")
        encoding.clear(); // whatever it says, it is written in bytes; ASCII has no others than UTF-8
    if (encoding.empty())
    {
        result.mend(text.substr(result._markBytes));
        return result;
    }
    int line = 0;
    const bool isLatin = encoding == "ISO-8859-1" || encoding == "ISO_8859-1" || encoding == "LATIN1";
    std::optional<std::string> converted = toUtf8(text, isLatin ? "CP1252" : encoding.c_str(), &line);
    if (!converted && isLatin) converted = toUtf8(text, "ISO-8859-1", &line);
    if (!converted && line == 0)
        return Error{name + ":1", "the encoding '" + encoding + "' is unknown", "save the file as UTF-8"};
    if (!converted)
        return Error{name + ":" + std::to_string(line), "not valid " + encoding, "save the file as UTF-8"};
    result.take(std::move(*converted));
    return result;
}

inline void Utf8Text::mend(std::string_view text)
{
    std::size_t kept = 0; // of `text`, that is in _text
    for (std::size_t at = 0; at < text.size();)
    {
        const std::size_t length = utf8Length(text, at);
        if (length == 0)
        {
            if (_strayBytes++ == 0)
                _strayLine = 1 + static_cast<int>(
                                     std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
            _text += text.substr(kept, at - kept);
            const std::string_view stray = text.substr(at, 1);
            std::optional<std::string> letter = toUtf8(stray, "CP1252");
            if (!letter) letter = toUtf8(stray, "ISO-8859-1");
            _text += letter.value_or("?");
            kept = at + 1;
        }
        at += std::max<std::size_t>(length, 1);
    }
    if (_strayBytes == 0) return;
    _text += text.substr(kept);
    _isConverted = true;
}

/// Returns the encoding that the declaration of an XML text names; empty: it names none.
/// Source: W3C, *Extensible Markup Language (XML) 1.0*, 5th edition, productions 23, 80 and 81.
inline std::string xmlEncodingOf(std::string_view text)
{
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (!text.starts_with("<?xml")) return {};
    text = text.substr(0, text.find("?>"));
    const std::size_t word = text.find("encoding");
    if (word == std::string_view::npos) return {};
    const std::size_t quote = text.find_first_of("\"'", word);
    if (quote == std::string_view::npos) return {};
    const std::size_t end = text.find(text[quote], quote + 1);
    if (end == std::string_view::npos) return {};
    std::string name(text.substr(quote + 1, end - quote - 1));
    const bool isName =
        std::all_of(name.begin(), name.end(),
                    [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '_' || c == '-'; });
    return isName ? name : std::string{};
}

} // namespace foundation
