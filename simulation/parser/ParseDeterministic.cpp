// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "simulation/parser/ElementParsers.h"
#include "simulation/parser/Expression.h"
#include "simulation/parser/ParseDistributions.h"

namespace simulation
{
namespace
{

constexpr double kMostSteps = 1e5;

std::vector<std::string> parseSet(ElementReader reader)
{
    reader.allowChildren({"Element"});
    std::vector<std::string> values;
    for (pugi::xml_node node : reader.node.children("Element"))
        values.push_back(ElementReader(reader.context, node).text("value"));
    if (values.empty()) reader.context.invalid(reader.node, "a DistributionSet has no Element", "add one");
    return values;
}

/// The values lower, lower + step, … up to upper, which counts as reached within a millionth of a step.
std::vector<std::string> parseRange(ElementReader reader)
{
    reader.allowChildren({"Range"});
    ElementReader range = reader.child("Range");
    const double lower = range.number("lowerLimit"), upper = range.number("upperLimit");
    const double step = reader.number("stepWidth");
    std::vector<std::string> values;
    if (!(step > 0.0))
        reader.context.invalid(reader.node, "DistributionRange/stepWidth is not above 0",
                               "write a positive width");
    else if (upper < lower)
        reader.context.invalid(range.node, "Range/upperLimit is below lowerLimit", "swap them");
    else if ((upper - lower) / step > kMostSteps)
        reader.context.invalid(reader.node, "the range has more than 100000 values", "widen the step");
    else
        for (double i = 0.0; lower + i * step <= upper + 1e-6 * step; i += 1.0)
            values.push_back(formatNumber(lower + i * step));
    return values;
}

std::vector<ParameterValues> parseSingle(ElementReader reader)
{
    const std::string parameter = reader.text("parameterName");
    ElementReader content = reader.onlyChild();
    std::vector<std::string> values;
    if (content.is("DistributionSet"))
        values = parseSet(content);
    else if (content.is("DistributionRange"))
        values = parseRange(content);
    else
        unsupportedContent(content, "distribution");
    std::vector<ParameterValues> choices;
    for (std::string& value : values)
        choices.push_back({{parameter, std::move(value)}});
    return choices;
}

std::vector<ParameterValues> parseMulti(ElementReader reader)
{
    std::vector<ParameterValues> choices;
    ElementReader content = reader.onlyChild();
    if (!content.is("ValueSetDistribution"))
    {
        unsupportedContent(content, "distribution");
        return choices;
    }
    content.allowChildren({"ParameterValueSet"});
    for (pugi::xml_node set : content.node.children("ParameterValueSet"))
    {
        ElementReader(reader.context, set).allowChildren({"ParameterAssignment"});
        ParameterValues values;
        for (pugi::xml_node node : set.children("ParameterAssignment"))
        {
            ElementReader assignment(reader.context, node);
            values.emplace_back(assignment.text("parameterRef"), assignment.text("value"));
        }
        choices.push_back(std::move(values));
    }
    if (choices.empty())
        reader.context.invalid(content.node, "a ValueSetDistribution has no ParameterValueSet", "add one");
    return choices;
}

} // namespace

std::vector<ParameterValues> parseDeterministic(ElementReader distribution)
{
    if (distribution.is("DeterministicSingleParameterDistribution")) return parseSingle(distribution);
    if (distribution.is("DeterministicMultiParameterDistribution")) return parseMulti(distribution);
    unsupportedContent(distribution, "distribution");
    return {};
}

} // namespace simulation
