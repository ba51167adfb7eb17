// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "simulation/parser/Keywords.h"
#include "simulation/parser/ParseContext.h"

namespace simulation
{

/// Reads the attributes and children of one element as typed values and replaces parameters. A missing or
/// wrong value becomes a problem of the context and is returned as a neutral value, so that callers need not
/// check each attribute.
class ElementReader
{
public:
    ElementReader(ParseContext& contextIn, pugi::xml_node nodeIn) : context(contextIn), node(nodeIn)
    {
        if (node) context.touch(node);
    }

    bool is(std::string_view name) const { return node.name() == name; }
    /// Whether there is such an attribute; it counts as read.
    bool has(const char* attribute) const
    {
        const pugi::xml_attribute found = node.attribute(attribute);
        if (found) context.read(found);
        return static_cast<bool>(found);
    }

    std::string text(const char* attribute);
    std::string textOr(const char* attribute, const std::string& fallback);
    /// Returns a text on which no motion depends; one that is missing is told and left empty.
    std::string textAssumed(const char* attribute);
    /// Returns the attribute `name`, at most 256 characters, because each storyboard element keeps the path
    /// of its names. Names are text: `${…}` in a name is not computed. One that is missing is told and left
    /// empty.
    std::string name();
    /// Returns a finite number within ±1e9. This bound keeps everything that is computed from it finite.
    double number(const char* attribute);
    double numberOr(const char* attribute, double fallback);
    /// A number that is missing is told, and `fallback` is taken.
    double numberAssumed(const char* attribute, double fallback);
    /// Returns a number that only bounds others, or is compared with them: `INF` and what is beyond 1e9 count
    /// as 1e9.
    double bound(const char* attribute);
    std::optional<double> optionalBound(const char* attribute);
    std::optional<double> optionalNumber(const char* attribute);
    double notNegative(const char* attribute);
    int count(const char* attribute, int fallback);
    bool flagOr(const char* attribute, bool fallback);

    template<class Value, std::size_t Count>
    Value choice(const char* attribute, const Keywords<Value, Count>& keywords)
    {
        const std::string word = text(attribute);
        for (const auto& [candidate, value] : keywords)
            if (candidate == word) return value;
        if (has(attribute))
        {
            std::vector<std::string_view> words;
            for (const auto& keyword : keywords)
                words.push_back(keyword.first);
            unknownWord(attribute, word, words);
        }
        return keywords.front().second;
    }

    template<class Value, std::size_t Count>
    Value choiceOr(const char* attribute, const Keywords<Value, Count>& keywords, Value fallback)
    {
        return has(attribute) ? choice(attribute, keywords) : fallback;
    }

    /// A word that is missing is told, and the first one is taken.
    template<class Value, std::size_t Count>
    Value choiceAssumed(const char* attribute, const Keywords<Value, Count>& keywords)
    {
        if (!node || has(attribute)) return choice(attribute, keywords);
        assume(attribute, std::string(keywords.front().first) + " is taken");
        return keywords.front().second;
    }

    /// Returns the child of that name. A missing child is a problem, and an empty element is returned.
    ElementReader child(const char* name);

    bool hasContent() const; ///< a child element, whatever its name

    /// Returns the only child element, whatever its name; of several the first that the standard has. No
    /// child is a problem, and an empty element is returned.
    ElementReader onlyChild();

    /// Reports each other child element as an unsupported one.
    void allowChildren(std::initializer_list<std::string_view> names);

    ParseContext& context;
    pugi::xml_node node;

private:
    void assume(const char* attribute, const std::string& instead);
    void unknownWord(const char* attribute, const std::string& word,
                     const std::vector<std::string_view>& words);
    std::optional<std::string> substituted(const char* attribute);
};

} // namespace simulation
