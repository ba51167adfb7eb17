// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <numeric>

#include "simulation/parser/ElementParsers.h"
#include "simulation/parser/Expression.h"
#include "simulation/parser/ParseDistributions.h"

namespace simulation
{
namespace
{

using Draw = std::function<std::string(RandomDraw&)>;

constexpr int kMostDraws = 100;         ///< until one is within the range
constexpr double kGreatestMean = 700.0; ///< exp(-mean) is a number

struct ValueRange
{
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
};

ValueRange parseRangeOf(ElementReader reader)
{
    const ValueRange range{reader.number("lowerLimit"), reader.number("upperLimit")};
    if (reader.node && range.upper < range.lower)
        reader.context.invalid(reader.node, "Range/upperLimit is below lowerLimit", "swap them");
    return range;
}

ValueRange parseOptionalRange(ElementReader& parent)
{
    parent.allowChildren({"Range"});
    const pugi::xml_node node = parent.node.child("Range");
    return node ? parseRangeOf({parent.context, node}) : ValueRange{};
}

/// Draws until a value is within the range; after many that are not, takes the limit that is nearest to the
/// last.
template<class Sample>
Draw within(const ValueRange& range, Sample sample)
{
    return [=](RandomDraw& random)
    {
        double value = sample(random);
        for (int i = 0; i < kMostDraws && !(value >= range.lower && value <= range.upper); ++i)
            value = sample(random);
        return formatNumber(std::min(std::max(value, range.lower), range.upper));
    };
}

/// The weights of elements or bins; a problem where nothing could be drawn.
std::vector<double> parseWeights(ElementReader& reader, const char* child)
{
    reader.allowChildren({"Element", "Bin"});
    std::vector<double> weights;
    for (pugi::xml_node node : reader.node.children(child))
        weights.push_back(ElementReader(reader.context, node).notNegative("weight"));
    if (!(std::accumulate(weights.begin(), weights.end(), 0.0) > 0.0))
        reader.context.invalid(reader.node, std::string(reader.node.name()) + " has no weight above 0",
                               "add one");
    return weights;
}

Draw parseProbabilitySet(ElementReader reader)
{
    const std::vector<double> weights = parseWeights(reader, "Element");
    std::vector<std::string> values;
    for (pugi::xml_node node : reader.node.children("Element"))
        values.push_back(ElementReader(reader.context, node).text("value"));
    if (values.empty()) return {};
    return [=](RandomDraw& random) { return values[random.index(weights)]; };
}

Draw parseHistogram(ElementReader reader)
{
    const std::vector<double> weights = parseWeights(reader, "Bin");
    std::vector<ValueRange> bins;
    for (pugi::xml_node node : reader.node.children("Bin"))
        bins.push_back(parseRangeOf(ElementReader(reader.context, node).child("Range")));
    if (bins.empty()) return {};
    return [=](RandomDraw& random)
    {
        const ValueRange& bin = bins[random.index(weights)];
        return formatNumber(random.uniform(bin.lower, bin.upper));
    };
}

Draw parseMoments(ElementReader reader)
{
    const ValueRange range = parseOptionalRange(reader);
    const double mean = reader.number("expectedValue"), variance = reader.notNegative("variance");
    if (reader.is("NormalDistribution"))
        return within(range, [=](RandomDraw& random) { return random.normal(mean, variance); });
    if (mean > 0.0)
        return within(range, [=](RandomDraw& random) { return random.logNormal(mean, variance); });
    reader.context.invalid(reader.node, "LogNormalDistribution/expectedValue is not above 0",
                           "write a positive value");
    return {};
}

Draw parsePoisson(ElementReader reader)
{
    const ValueRange range = parseOptionalRange(reader);
    const double mean = reader.notNegative("expectedValue");
    if (mean <= kGreatestMean) return within(range, [=](RandomDraw& random) { return random.poisson(mean); });
    reader.context.invalid(reader.node, "PoissonDistribution/expectedValue is above 700",
                           "use a NormalDistribution");
    return {};
}

Draw parseUniform(ElementReader reader)
{
    reader.allowChildren({"Range"});
    const ValueRange range = parseRangeOf(reader.child("Range"));
    return [=](RandomDraw& random) { return formatNumber(random.uniform(range.lower, range.upper)); };
}

} // namespace

StochasticDistribution parseStochastic(ElementReader distribution)
{
    const std::string parameter = distribution.text("parameterName");
    ElementReader content = distribution.onlyChild();
    if (content.is("ProbabilityDistributionSet")) return {parameter, parseProbabilitySet(content)};
    if (content.is("NormalDistribution") || content.is("LogNormalDistribution"))
        return {parameter, parseMoments(content)};
    if (content.is("UniformDistribution")) return {parameter, parseUniform(content)};
    if (content.is("PoissonDistribution")) return {parameter, parsePoisson(content)};
    if (content.is("Histogram")) return {parameter, parseHistogram(content)};
    unsupportedContent(content, "distribution");
    return {parameter, {}};
}

} // namespace simulation
