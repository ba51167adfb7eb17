// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/XmlSource.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace simulation
{
namespace
{

constexpr int kMaximumDepth = 64;

bool isWideEncoding(std::string_view text)
{
    const auto startsWith = [&](std::string_view mark) { return text.substr(0, mark.size()) == mark; };
    return startsWith("\xFE\xFF") || startsWith("\xFF\xFE") ||
           startsWith(std::string_view("\0\0\xFE\xFF", 4)) || startsWith(std::string_view("<\0", 2)) ||
           startsWith(std::string_view("\0<", 2)) || startsWith(std::string_view("\0\0\0<", 4));
}

} // namespace

foundation::Result<std::unique_ptr<XmlSource>> XmlSource::read(const std::filesystem::path& file,
                                                               std::size_t maximumBytes)
{
    const std::string name = file.string();
    std::error_code code;
    if (!std::filesystem::is_regular_file(file, code))
        return foundation::Error{name,
                                 std::filesystem::exists(file, code) ? "not a regular file" : "no such file",
                                 "check the path"};
    const std::uintmax_t bytes = std::filesystem::file_size(file, code);
    if (code || bytes > maximumBytes)
        return foundation::Error{name, "larger than the limit of " + std::to_string(maximumBytes) + " bytes",
                                 "split the file"};
    std::ifstream stream(file, std::ios::binary);
    std::string text(static_cast<std::size_t>(bytes), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream && bytes > 0) return foundation::Error{name, "cannot be read", "check its permissions"};
    return parse(text, name);
}

foundation::Result<std::unique_ptr<XmlSource>> XmlSource::parse(std::string_view text,
                                                                const std::string& name)
{
    if (isWideEncoding(text)) return foundation::Error{name, "not in UTF-8", "save the file as UTF-8"};
    auto source = std::make_unique<XmlSource>();
    source->_name = name;
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
        source->_newlines.push_back(static_cast<std::ptrdiff_t>(at));
    const pugi::xml_parse_result parsed = source->_document.load_buffer(
        text.data(), text.size(), pugi::parse_default, pugi::xml_encoding::encoding_utf8);
    if (!parsed)
        return foundation::Error{name + ":" + std::to_string(source->lineAt(parsed.offset)),
                                 std::string("not well-formed XML: ") + parsed.description(),
                                 "correct the file"};
    if (foundation::Outcome depth = source->checkDepth(); !depth) return depth.error();
    return source;
}

int XmlSource::lineOf(pugi::xml_node node) const
{
    return lineAt(node.offset_debug());
}

int XmlSource::lineAt(std::ptrdiff_t offset) const
{
    if (offset < 0) return 0;
    return static_cast<int>(std::lower_bound(_newlines.begin(), _newlines.end(), offset) -
                            _newlines.begin()) +
           1;
}

/// Walks without recursion: a hostile file may nest as deep as it is long.
foundation::Outcome XmlSource::checkDepth() const
{
    int depth = 1;
    for (pugi::xml_node node = root(); node;)
    {
        if (depth > kMaximumDepth)
            return foundation::Error{_name + ":" + std::to_string(lineOf(node)),
                                     "elements are nested deeper than " + std::to_string(kMaximumDepth),
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
    return foundation::success();
}

} // namespace simulation
