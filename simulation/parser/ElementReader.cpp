// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementReader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/parser/Coverage.h"
#include "simulation/parser/Expression.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMaximumName = 256;
constexpr double kLargestNumber = 1e9;

std::string listed(const std::vector<std::string_view>& words)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + std::string(words[i]);
    return text;
}

/// A number of xsd:double, or what is written for one without bound, within ±1e9.
std::optional<double> parseBound(const std::string& text)
{
    const bool isBelow = text.starts_with('-');
    for (const char* word : {"INF", "inf", "Infinity", "infinity"})
        if (text.substr(isBelow ? 1 : 0) == word) return isBelow ? -kLargestNumber : kLargestNumber;
    const std::optional<double> value = parseNumber(text);
    return value ? std::optional(std::clamp(*value, -kLargestNumber, kLargestNumber)) : std::nullopt;
}

/// What was probably meant where a number should stand.
std::string numberRemedy(const ParseContext& context, std::string text)
{
    if (context.lookup(text)) return "write $" + text + " for the parameter";
    std::replace(text.begin(), text.end(), ',', '.');
    if (parseNumber(text)) return "write a point, not a comma: " + text;
    return "write a number, without a unit";
}

} // namespace

std::string ElementReader::text(const char* attribute)
{
    if (!has(attribute))
    {
        if (node)
            context.invalid(node, std::string(node.name()) + " has no attribute " + attribute, "add it");
        return {};
    }
    return substituted(attribute).value_or("");
}

std::string ElementReader::textOr(const char* attribute, const std::string& fallback)
{
    return has(attribute) ? text(attribute) : fallback;
}

std::string ElementReader::textAssumed(const char* attribute)
{
    if (!node || has(attribute)) return text(attribute);
    assume(attribute, "it is left empty");
    return {};
}

/// `$name` and `${expression}` stand for the whole value, as the language has it. Nothing after a problem.
std::optional<std::string> ElementReader::substituted(const char* attribute)
{
    const std::string raw = node.attribute(attribute).value();
    if (raw.empty() || raw.front() != '$') return raw;
    const std::string where = std::string(node.name()) + "/" + attribute;
    if (raw.size() > 1 && raw[1] == '{')
    {
        if (raw.back() != '}')
        {
            context.invalid(node, "the expression in " + where + " does not end with }", "close it");
            return std::nullopt;
        }
        const foundation::Result<double> value =
            evaluateExpression(std::string_view(raw).substr(2, raw.size() - 3),
                               [this](std::string_view name) { return context.lookup(name); });
        if (value) return formatNumber(*value);
        context.invalid(node, "the expression in " + where + ": " + value.error().what, value.error().remedy);
        return std::nullopt;
    }
    if (std::optional<std::string> value = context.lookup(std::string_view(raw).substr(1))) return value;
    context.invalid(node, "the parameter " + raw + " in " + where + " is not declared",
                    "declare it before its use");
    return std::nullopt;
}

std::string ElementReader::name()
{
    const std::string_view raw = has("name") ? node.attribute("name").value() : "";
    std::string name = raw.starts_with("${") ? std::string(raw) : textAssumed("name");
    if (name.size() <= kMaximumName) return name;
    context.invalid(node, "the name is longer than " + std::to_string(kMaximumName) + " characters",
                    "shorten it");
    return name.substr(0, kMaximumName);
}

double ElementReader::number(const char* attribute)
{
    const std::optional<std::string> content = has(attribute) ? substituted(attribute) : text(attribute);
    if (!has(attribute) || !content) return 0.0;
    const std::optional<double> value = parseNumber(*content);
    if (value && std::fabs(*value) <= kLargestNumber) return *value;
    if (value)
    {
        context.invalid(node, std::string(node.name()) + "/" + attribute + " is beyond 1e9",
                        "write a smaller number");
        return 0.0;
    }
    context.invalid(node,
                    std::string(node.name()) + "/" + attribute + " is not a finite number: \"" +
                        content->substr(0, 40) + "\"",
                    numberRemedy(context, *content));
    return 0.0;
}

double ElementReader::numberOr(const char* attribute, double fallback)
{
    return has(attribute) ? number(attribute) : fallback;
}

double ElementReader::numberAssumed(const char* attribute, double fallback)
{
    if (!node || has(attribute)) return number(attribute);
    assume(attribute, formatNumber(fallback) + " is taken");
    return fallback;
}

double ElementReader::bound(const char* attribute)
{
    if (!has(attribute)) return number(attribute);
    const std::optional<std::string> content = substituted(attribute);
    const std::optional<double> value = content ? parseBound(*content) : std::nullopt;
    return value ? *value : number(attribute); // which tells what is wrong
}

std::optional<double> ElementReader::optionalBound(const char* attribute)
{
    if (!has(attribute)) return std::nullopt;
    return bound(attribute);
}

std::optional<double> ElementReader::optionalNumber(const char* attribute)
{
    if (!has(attribute)) return std::nullopt;
    return number(attribute);
}

double ElementReader::notNegative(const char* attribute)
{
    const double value = bound(attribute);
    if (value >= 0.0) return value;
    context.invalid(node, std::string(node.name()) + "/" + attribute + " is negative", "write 0 or more");
    return 0.0;
}

int ElementReader::count(const char* attribute, int fallback)
{
    const double value = numberOr(attribute, fallback);
    if (value >= 0.0 && value <= 1e9 && value == std::floor(value)) return static_cast<int>(value);
    context.invalid(node, std::string(node.name()) + "/" + attribute + " is not a count",
                    "write a whole number");
    return fallback;
}

bool ElementReader::flagOr(const char* attribute, bool fallback)
{
    const std::string word = textOr(attribute, fallback ? "true" : "false");
    if (word == "true" || word == "1" || word == "True") return true;
    if (word != "false" && word != "0" && word != "False") unknownWord(attribute, word, {"true", "false"});
    return false;
}

ElementReader ElementReader::child(const char* name)
{
    const pugi::xml_node found = node.child(name);
    if (!found && node) context.invalid(node, std::string(node.name()) + " has no element " + name, "add it");
    return {context, found};
}

bool ElementReader::hasContent() const
{
    return static_cast<bool>(
        node.find_child([](pugi::xml_node child) { return child.type() == pugi::node_element; }));
}

ElementReader ElementReader::onlyChild()
{
    pugi::xml_node chosen;
    for (pugi::xml_node candidate : node.children())
    {
        if (candidate.type() != pugi::node_element) continue;
        const bool isBetter = !chosen || (!coverageOf(chosen.name()) && coverageOf(candidate.name()));
        const pugi::xml_node surplus = isBetter ? std::exchange(chosen, candidate) : candidate;
        if (surplus) context.foreign(surplus, std::string("the element ") + surplus.name());
    }
    if (chosen) return {context, chosen};
    if (node) context.invalid(node, std::string(node.name()) + " is empty", "add its content");
    return {context, pugi::xml_node()};
}

void ElementReader::allowChildren(std::initializer_list<std::string_view> names)
{
    for (pugi::xml_node candidate : node.children())
    {
        if (candidate.type() != pugi::node_element) continue;
        if (std::find(names.begin(), names.end(), candidate.name()) == names.end())
            context.foreign(candidate, std::string("the element ") + candidate.name());
    }
}

void ElementReader::assume(const char* attribute, const std::string& instead)
{
    context.assumed(node, std::string(node.name()) + " has no attribute " + attribute, instead + "; add it");
}

void ElementReader::unknownWord(const char* attribute, const std::string& word,
                                const std::vector<std::string_view>& words)
{
    context.invalid(node,
                    std::string(node.name()) + "/" + attribute + " has the unknown value \"" +
                        word.substr(0, 40) + "\"",
                    "write " + listed(words));
}

} // namespace simulation
