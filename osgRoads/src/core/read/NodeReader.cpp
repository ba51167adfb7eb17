// SPDX-License-Identifier: Apache-2.0
#include "NodeReader.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace osgRoads::core
{

namespace
{

constexpr double kLargestNumber = 1e12;
constexpr std::size_t kMostQuoted = 40;

bool isKnown(const std::vector<const char*>& names, const char* name)
{
    return std::any_of(names.begin(), names.end(),
                       [&](const char* known) { return std::strcmp(known, name) == 0; });
}

std::optional<double> numberIn(std::string_view text)
{
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const std::from_chars_result read = std::from_chars(text.data(), end, value);
    // Too near to 0, or too large: from_chars does not tell which.
    if (read.ec == std::errc::result_out_of_range)
        value = std::strtod(std::string(text).c_str(), nullptr);
    else if (read.ec != std::errc())
        return std::nullopt;
    if (text.empty() || read.ptr != end) return std::nullopt;
    return std::fabs(value) <= kLargestNumber ? std::optional(value) : std::nullopt; // no NaN either
}

} // namespace

bool NodeReader::has(const char* attribute)
{
    _knownAttributes.push_back(attribute);
    return static_cast<bool>(node.attribute(attribute));
}

std::string NodeReader::text(const char* attribute)
{
    return has(attribute) ? node.attribute(attribute).value() : "";
}

std::string NodeReader::id(const char* attribute)
{
    std::string found = text(attribute);
    if (found.empty()) mistake(std::string(node.name()) + " has no attribute " + attribute, "add it");
    return found;
}

double NodeReader::number(const char* attribute)
{
    if (const std::optional<double> value = optionalNumber(attribute)) return *value;
    if (!node.attribute(attribute))
        mistake(std::string(node.name()) + " has no attribute " + attribute, "add it");
    return 0.0;
}

double NodeReader::numberOr(const char* attribute, double fallback)
{
    return optionalNumber(attribute).value_or(fallback);
}

std::optional<double> NodeReader::optionalNumber(const char* attribute)
{
    if (!has(attribute)) return std::nullopt;
    const std::string_view content = node.attribute(attribute).value();
    if (const std::optional<double> value = numberIn(content)) return value;
    mistake(named(attribute) + " is not a finite number: \"" + std::string(content.substr(0, kMostQuoted)) +
                "\"",
            "write a number within ±1e12; 0 is used");
    return 0.0;
}

int NodeReader::integer(const char* attribute, int fallback)
{
    if (!has(attribute)) return fallback;
    const std::optional<double> value = numberIn(node.attribute(attribute).value());
    if (value && std::fabs(*value) <= 1e9 && *value == std::floor(*value)) return static_cast<int>(*value);
    mistake(named(attribute) + " is not a whole number: \"" +
                std::string(node.attribute(attribute).value()).substr(0, kMostQuoted) + "\"",
            "write a whole number");
    return fallback;
}

bool NodeReader::flag(const char* attribute)
{
    const std::string word = text(attribute);
    if (word == "true" || word == "1" || word == "yes") return true;
    if (!word.empty() && word != "false" && word != "0" && word != "no") unknownWord(attribute, word);
    return false;
}

Cubic NodeReader::cubic(const char* startName)
{
    return {number(startName), numberOr("a", 0.0), numberOr("b", 0.0), numberOr("c", 0.0),
            numberOr("d", 0.0)};
}

CubicProfile NodeReader::profile(const char* name, const char* startName)
{
    std::vector<Cubic> pieces;
    each(name, [&](NodeReader& entry) { pieces.push_back(entry.cubic(startName)); });
    sortByStart(*this, name, pieces);
    return CubicProfile(std::move(pieces));
}

void NodeReader::reportRest()
{
    const std::string element = node.name();
    for (const pugi::xml_attribute attribute : node.attributes())
        if (!isKnown(_knownAttributes, attribute.name()))
            context.unsupported(node, element + "@" + attribute.name());
    for (const pugi::xml_node child : node.children())
    {
        if (child.type() != pugi::node_element || isKnown(_knownChildren, child.name())) continue;
        if (std::strcmp(child.name(), "userData") == 0 || std::strcmp(child.name(), "dataQuality") == 0)
            continue; // additional data, which any element may have
        context.unsupported(child, element + "/" + child.name());
    }
}

std::string NodeReader::named(const char* attribute) const
{
    return std::string(node.name()) + "/" + attribute;
}

void NodeReader::unknownWord(const char* attribute, std::string_view word)
{
    mistake(named(attribute) + " has the unknown value \"" + std::string(word.substr(0, kMostQuoted)) + "\"",
            "use a word of the standard");
}

char readOrientation(NodeReader& element)
{
    const std::string word = element.text("orientation");
    if (word == "+" || word == "-") return word.front();
    if (!word.empty() && word != "none" && word != "both")
        element.mistake("orientation has the unknown value \"" + word.substr(0, kMostQuoted) + "\"",
                        "write +, - or none");
    return '0';
}

} // namespace osgRoads::core
