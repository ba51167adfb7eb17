// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/VehicleFileReader.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include <foundation/Excerpt.h>
#include <foundation/NearestWord.h>

namespace simulation
{

namespace
{

std::string textOf(double number)
{
    std::ostringstream text;
    text << number;
    return text.str();
}

/// A number that is the whole text, blanks around it aside.
std::optional<double> attributeNumber(std::string_view text)
{
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    double number = 0.0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failed != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return {};
    return number;
}

/// The lines of numbers in a text; nothing where a word is no number.
std::optional<std::vector<std::vector<double>>> parseLines(const std::string& text, std::string& wrong)
{
    std::vector<std::vector<double>> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
    {
        std::vector<double> numbers;
        std::istringstream words(line);
        for (std::string word; words >> word;)
        {
            const std::optional<double> number = attributeNumber(word);
            if (!number) return wrong = word, std::nullopt;
            numbers.push_back(*number);
        }
        if (!numbers.empty()) lines.push_back(std::move(numbers));
    }
    return lines;
}

} // namespace

void VehicleFileReader::fail(pugi::xml_node node, const std::string& what, std::string remedy)
{
    if (_error) return;
    _error = foundation::Error{_source.name() + ":" + std::to_string(_source.lineOf(node)),
                               foundation::excerpt(what), std::move(remedy)};
}

double VehicleFileReader::number(pugi::xml_node node, const char* attribute, double least, double most)
{
    const pugi::xml_attribute found = node.attribute(attribute);
    const std::string label = std::string("<") + node.name() + "> ";
    const std::string remedy =
        std::string("give ") + attribute + " as a number from " + textOf(least) + " to " + textOf(most);
    if (!found)
    {
        fail(node, label + "has no " + attribute, remedy);
        return 0.0;
    }
    const std::optional<double> value = attributeNumber(found.value());
    if (!value || *value < least || *value > most)
    {
        fail(node, label + attribute + " is '" + found.value() + "'", remedy);
        return 0.0;
    }
    return *value;
}

glm::dvec3 VehicleFileReader::place(pugi::xml_node node)
{
    return {number(node, "xM", -100.0, 100.0), number(node, "yM", -100.0, 100.0),
            number(node, "zM", -100.0, 100.0)};
}

Table VehicleFileReader::table(pugi::xml_node node, bool hasColumns)
{
    const std::string label = std::string("the table of <") + node.name() + "> ";
    std::string wrong;
    const auto lines = parseLines(node.child_value(), wrong);
    if (!lines)
        fail(node, label + "has '" + wrong + "'", "write numbers, a row of the table on a line");
    else if (lines->empty())
        fail(node, label + "is empty", "write a number or a table");
    if (_error) return Table(0.0);
    if (lines->size() == 1 && lines->front().size() == 1) return Table(lines->front().front());
    const std::size_t first = hasColumns ? 1 : 0;
    std::vector<double> rows, values;
    const std::vector<double> columns = hasColumns ? lines->front() : std::vector<double>{0.0};
    for (std::size_t i = first; i < lines->size(); ++i)
    {
        const std::vector<double>& line = (*lines)[i];
        rows.push_back(line.front());
        values.insert(values.end(), line.begin() + 1, line.end());
        if (line.size() != columns.size() + 1)
            fail(node, label + "has a row of " + std::to_string(line.size()) + " numbers",
                 "give each row its argument and " + std::to_string(columns.size()) + " values");
    }
    if (_error) return Table(0.0);
    foundation::Result<Table> made = Table::of(std::move(rows), columns, std::move(values));
    if (made) return std::move(*made);
    fail(node, label + made.error().what, made.error().remedy);
    return Table(0.0);
}

std::string VehicleFileReader::name(pugi::xml_node node)
{
    const std::string name = node.attribute("name").value();
    if (name.empty()) fail(node, std::string("<") + node.name() + "> has no name", "give it one");
    return name;
}

pugi::xml_node VehicleFileReader::child(pugi::xml_node parent, const char* name)
{
    const pugi::xml_node found = parent.child(name);
    if (!found)
        fail(parent, std::string("<") + parent.name() + "> has no <" + name + ">", "add it");
    else if (found.next_sibling(name))
        fail(found.next_sibling(name), std::string("there is a second <") + name + ">", "keep one");
    return found;
}

void VehicleFileReader::onlyAttributes(pugi::xml_node node, std::string_view names)
{
    const std::string padded = " name source " + std::string(names) + " ";
    for (const pugi::xml_attribute attribute : node.attributes())
        if (padded.find(std::string(" ") + attribute.name() + " ") == std::string::npos)
            fail(node,
                 std::string("<") + node.name() + "> has an unknown attribute '" + attribute.name() + "'",
                 lists(attribute.name(), padded));
}

void VehicleFileReader::onlyElements(pugi::xml_node root, std::string_view names)
{
    const std::string padded = " " + std::string(names) + " ";
    for (const pugi::xml_node node : root.children("source"))
        listSource(node);
    for (const pugi::xml_node node : root.children())
    {
        if (node.type() != pugi::node_element || std::string_view(node.name()) == "source") continue;
        if (padded.find(std::string(" ") + node.name() + " ") == std::string::npos)
            fail(node, std::string("<") + node.name() + "> is unknown", lists(node.name(), padded));
        checkSource(node);
    }
}

std::string VehicleFileReader::lists(std::string_view misspelt, std::string_view names) const
{
    return foundation::didYouMean(misspelt, names, "remove it; " + std::string(_page) + " lists all");
}

void VehicleFileReader::listSource(pugi::xml_node node)
{
    const std::string key = node.attribute("key").value();
    if (key.empty() || std::string_view(node.child_value()).empty())
        fail(node, "<source> has no key or no text",
             "write <source key=\"KEY\">author, title, year</source>");
    else if (!_sources.insert(key).second)
        fail(node, "the source '" + key + "' is listed twice", "keep one");
}

void VehicleFileReader::checkSource(pugi::xml_node node)
{
    const std::string key = node.attribute("source").value();
    if (!_sources.contains(key))
        fail(node,
             key.empty() ? std::string("<") + node.name() + "> names no source"
                         : "the source '" + key + "' is not listed",
             "say where the numbers are from: source=\"KEY\" of a <source key=\"KEY\"> above");
}

} // namespace simulation
