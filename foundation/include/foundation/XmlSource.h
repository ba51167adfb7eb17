// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <foundation/Result.h>
#include <foundation/Utf8.h>
#include <pugixml.hpp>

namespace foundation
{

namespace xml
{

inline constexpr int kMaximumDepth = 64;

} // namespace xml

/// A parsed XML text that knows the line of each of its elements. Whoever includes this links pugixml.
/// Memory: about four times the text.
class XmlSource
{
public:
    /// Errors: not a readable regular file, larger than `maximumBytes`, and those of parse().
    static Result<std::unique_ptr<XmlSource>> read(const std::filesystem::path& file,
                                                   std::size_t maximumBytes);

    /// The text may be in any encoding that its byte order mark or its declaration names (Utf8Text). Errors,
    /// as `name:line`: malformed, no root element, nested deeper than 64 elements, not valid in its encoding,
    /// an unknown one; as `name`: nothing in it, compressed.
    static Result<std::unique_ptr<XmlSource>> parse(std::string_view text, const std::string& name);

    pugi::xml_node root() const { return _document.document_element(); }
    const std::string& name() const { return _name; }
    int lineOf(pugi::xml_node node) const;
    int lineAt(std::ptrdiff_t offset) const;

    /// What the reader should tell of the text: bytes that are not in its encoding; empty: nothing.
    const std::string& note() const { return _note; }
    int noteLine() const { return _noteLine; }

private:
    Outcome checkDepth() const;

    std::string _name, _note;
    int _noteLine = 0;
    pugi::xml_document _document;
    std::vector<std::ptrdiff_t> _newlines; ///< offsets, ascending
};

inline Result<std::unique_ptr<XmlSource>> XmlSource::read(const std::filesystem::path& file,
                                                          std::size_t maximumBytes)
{
    const std::string name = file.string();
    std::error_code code;
    if (!std::filesystem::is_regular_file(file, code))
        return Error{name, std::filesystem::exists(file, code) ? "not a regular file" : "no such file",
                     "check the path"};
    const std::uintmax_t bytes = std::filesystem::file_size(file, code);
    if (code || bytes > maximumBytes)
        return Error{name, "larger than the limit of " + std::to_string(maximumBytes) + " bytes",
                     "split the file"};
    std::ifstream stream(file, std::ios::binary);
    std::string text(static_cast<std::size_t>(bytes), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream && bytes > 0) return Error{name, "cannot be read", "check its permissions"};
    return parse(text, name);
}

inline Result<std::unique_ptr<XmlSource>> XmlSource::parse(std::string_view text, const std::string& name)
{
    if (text.starts_with("\x1F\x8B")) return Error{name, "compressed by gzip", "unpack the file with gunzip"};
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return Error{name, "there is nothing in the file", "write it again, or name another one"};
    const Result<Utf8Text> read = Utf8Text::of(text, xmlEncodingOf(text), name);
    if (!read) return read.error();
    text = read->in(text);
    auto source = std::make_unique<XmlSource>();
    source->_name = name;
    if (read->strayBytes() > 0)
    {
        source->_note = read->strayWords();
        source->_noteLine = read->strayLine();
    }
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
        source->_newlines.push_back(static_cast<std::ptrdiff_t>(at));
    const pugi::xml_parse_result parsed = source->_document.load_buffer(
        text.data(), text.size(), pugi::parse_default, pugi::xml_encoding::encoding_utf8);
    if (!parsed)
        return Error{name + ":" + std::to_string(source->lineAt(parsed.offset)),
                     std::string("not well-formed XML: ") + parsed.description(), "correct the file"};
    if (Outcome depth = source->checkDepth(); !depth) return depth.error();
    return source;
}

inline int XmlSource::lineOf(pugi::xml_node node) const
{
    return lineAt(node.offset_debug());
}

inline int XmlSource::lineAt(std::ptrdiff_t offset) const
{
    if (offset < 0) return 0;
    return static_cast<int>(std::lower_bound(_newlines.begin(), _newlines.end(), offset) -
                            _newlines.begin()) +
           1;
}

/// Walks without recursion: a hostile file may nest as deep as it is long.
inline Outcome XmlSource::checkDepth() const
{
    int depth = 1;
    for (pugi::xml_node node = root(); node;)
    {
        if (depth > xml::kMaximumDepth)
            return Error{_name + ":" + std::to_string(lineOf(node)),
                         "elements are nested deeper than " + std::to_string(xml::kMaximumDepth),
                         "flatten the file"};
        if (node.first_child())
        {
            node = node.first_child();
            ++depth;
            continue;
        }
        while (node && node != root() && !node.next_sibling())
        {
            node = node.parent();
            --depth;
        }
        node = node == root() ? pugi::xml_node() : node.next_sibling();
    }
    return success();
}

} // namespace foundation
