// SPDX-License-Identifier: Apache-2.0
#include "SourceText.h"

namespace
{

constexpr std::string_view kBlanks = " \t\r\f\v";

/// A cursor goes through a text, line after line, and skips what the preprocessor takes away.
class Cursor
{
public:
    explicit Cursor(std::string_view text) : _text(text) {}

    bool atEnd() const { return _at >= _text.size(); }

    /// Goes to the end of a line of code, with the comments and literals that begin in it; tells whether it
    /// has code.
    bool passLine()
    {
        bool code = false;
        while (!atEnd())
        {
            const char c = _text[_at];
            if (c == '\n') return ++_at, code;
            if (startsWith("//"))
                passToLineEnd();
            else if (startsWith("/*"))
                passComment();
            else if (c == '"' || c == '\'')
                code = true, passLiteral(c);
            else
                code = code || kBlanks.find(c) == std::string_view::npos, ++_at;
        }
        return code;
    }

    /// The directive on this line without '#', with the lines that continue it; empty if there is none, and
    /// then nothing is passed.
    std::string_view directive()
    {
        const std::size_t first = _text.find_first_not_of(kBlanks, _at);
        if (first == std::string_view::npos || _text[first] != '#') return {};
        const std::size_t begin = first + 1;
        _at = begin;
        do
            passToLineEnd();
        while (!atEnd() && continued() && ++_at);
        const std::string_view found = _text.substr(begin, _at - begin);
        // A comment may begin on the line of a directive and end later.
        const std::size_t comment = found.rfind("/*");
        if (comment != std::string_view::npos && found.find("*/", comment) == std::string_view::npos &&
            found.find("//") == std::string_view::npos)
            _at = begin + comment, passComment(), passLine();
        else if (!atEnd())
            ++_at;
        return found.empty() ? " " : found;
    }

private:
    bool startsWith(std::string_view start) const { return _text.substr(_at, start.size()) == start; }
    void passToLineEnd() { _at = std::min(_text.find('\n', _at), _text.size()); }
    void passComment() { passTo("*/", _at + 2); }

    bool continued() const
    {
        const std::size_t before = _at > 1 && _text[_at - 1] == '\r' ? _at - 2 : _at - 1;
        return _at > 0 && _text[before] == '\\';
    }

    void passTo(std::string_view end, std::size_t from)
    {
        const std::size_t found = _text.find(end, from);
        _at = found == std::string_view::npos ? _text.size() : found + end.size();
    }

    void passLiteral(char quote)
    {
        if (quote == '"' && _at > 0 && _text[_at - 1] == 'R')
        {
            const std::size_t open = _text.find('(', _at);
            if (open == std::string_view::npos) return passToLineEnd();
            return passTo(")" + std::string(_text.substr(_at + 1, open - _at - 1)) + "\"", open);
        }
        // A quote between digits (1'000) begins a literal that ends with its line.
        for (++_at; !atEnd() && _text[_at] != quote && _text[_at] != '\n'; ++_at)
            if (_text[_at] == '\\') ++_at;
        if (!atEnd() && _text[_at] == quote) ++_at;
    }

    std::string_view _text;
    std::size_t _at = 0;
};

/// Adds the file that a directive includes, if it is an include line with a name.
void addInclude(std::string_view directive, std::vector<IncludeLine>& to)
{
    const std::size_t begin = directive.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos || directive.substr(begin, 7) != "include") return;
    const bool next = directive.substr(begin, 12) == "include_next";
    const std::size_t open = directive.find_first_of("<\"", begin);
    if (open == std::string_view::npos) return;
    const std::size_t close = directive.find(directive[open] == '<' ? '>' : '"', open + 1);
    if (close == std::string_view::npos) return;
    to.push_back({std::string(directive.substr(open + 1, close - open - 1)), directive[open] == '"', next});
}

} // namespace

SourceText readSourceText(std::string_view text)
{
    SourceText source;
    for (Cursor cursor(text); !cursor.atEnd();)
        if (const std::string_view directive = cursor.directive(); !directive.empty())
            addInclude(directive, source.includes);
        else
            source.lines += cursor.passLine();
    return source;
}
