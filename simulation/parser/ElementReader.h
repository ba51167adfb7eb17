// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "simulation/parser/Keywords.h"
#include "simulation/parser/ParseContext.h"

namespace simulation
{

/// Typed access to one element, parameters put in. What is missing or wrong becomes a problem of the context,
/// and a neutral value is returned, so that the caller need not look after every attribute.
class ElementReader
{
public:
    ElementReader(ParseContext& contextIn, pugi::xml_node nodeIn) : context(contextIn), node(nodeIn) {}

    bool is(std::string_view name) const { return node.name() == name; }
    bool has(const char* attribute) const { return static_cast<bool>(node.attribute(attribute)); }

    std::string text(const char* attribute);
    std::string textOr(const char* attribute, const std::string& fallback);
    /// The attribute `name`, at most 256 characters: paths of names are kept for every storyboard element. Names are
    /// text: `${…}` in one is no expression.
    std::string name();
    /// Finite and within ±1e9: nothing in a scene is larger, and what is computed from it stays finite.
    double number(const char* attribute);
    double numberOr(const char* attribute, double fallback);
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
        if (has(attribute)) unknownWord(attribute, word);
        return keywords.front().second;
    }

    template<class Value, std::size_t Count>
    Value choiceOr(const char* attribute, const Keywords<Value, Count>& keywords, Value fallback)
    {
        return has(attribute) ? choice(attribute, keywords) : fallback;
    }

    /// The child of that name; missing: a problem, and an empty element.
    ElementReader child(const char* name);

    /// The only child element, whatever its name; none: a problem, and an empty element.
    ElementReader onlyChild();

    /// Any other child element is a problem: unsupported.
    void allowChildren(std::initializer_list<std::string_view> names);

    ParseContext& context;
    pugi::xml_node node;

private:
    void unknownWord(const char* attribute, const std::string& word);
    std::optional<std::string> substituted(const char* attribute);
};

} // namespace simulation
