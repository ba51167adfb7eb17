// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>
#include <pugixml.hpp>

namespace simulation
{

/// A parsed XML text that knows the line of each of its elements.
/// Memory: about four times the text.
class XmlSource
{
public:
    /// Errors: not a readable regular file, larger than `maximumBytes`, and those of parse().
    static foundation::Result<std::unique_ptr<XmlSource>> read(const std::filesystem::path& file,
                                                               std::size_t maximumBytes);

    /// Errors, as `name:line`: malformed, no root element, UTF-16 or UTF-32, nested deeper than 64 elements.
    static foundation::Result<std::unique_ptr<XmlSource>> parse(std::string_view text,
                                                                const std::string& name);

    pugi::xml_node root() const { return _document.document_element(); }
    const std::string& name() const { return _name; }
    int lineOf(pugi::xml_node node) const;
    int lineAt(std::ptrdiff_t offset) const;

private:
    foundation::Outcome checkDepth() const;

    std::string _name;
    pugi::xml_document _document;
    std::vector<std::ptrdiff_t> _newlines; ///< offsets, ascending
};

} // namespace simulation
