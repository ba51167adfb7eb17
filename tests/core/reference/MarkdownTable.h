// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace reference
{

using Names = std::set<std::string>;

/// The text of a file of the source tree; empty: it cannot be read.
std::string sourceText(const std::filesystem::path& relative);

/// The texts of all .cpp files of a folder, but for the one of that stem.
std::string sourceTexts(const std::filesystem::path& folder, const std::string& exceptStem);

/// The words in backquotes within a text.
Names quotedIn(std::string_view text);

/// A page of docs/reference: headings with the tables below them.
class Page
{
public:
    explicit Page(std::string text) : _text(std::move(text)) {}
    static Page read(const std::string& name) { return Page(sourceText("docs/reference/" + name)); }

    /// The words in backquotes in one column (from 0) of the rows between the heading that reads so
    /// (backquotes left out) and the next heading.
    Names column(std::string_view heading, std::size_t column) const;
    /// The words in backquotes in the rows whose first cell has `name`, first cell left out.
    Names wordsBeside(std::string_view heading, const std::string& name) const;
    /// The headings that begin with a text, backquotes left out.
    Names headings(std::string_view beginning) const;
    /// The page without the rows whose first cell is `name` alone: for mutations.
    Page without(const std::string& name) const;
    /// The page with a row more below a heading.
    Page with(std::string_view heading, const std::string& name) const;

private:
    std::vector<std::vector<std::string>> rows(std::string_view heading) const;

    std::string _text;
};

/// What differs between a list of the code and one of the page, one sentence a name; empty: nothing. An empty
/// list of the code is a difference, too.
std::string differences(const Names& code, const Names& page);

} // namespace reference
