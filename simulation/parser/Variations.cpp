// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/Variations.h"

#include <cmath>

#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/CoverageWalk.h"
#include "simulation/parser/ElementParsers.h"
#include "simulation/parser/ParseDistributions.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMostVariations = 100'000;
constexpr double kMostValues = 1e5;

Variation variationOf(const ParameterValues& values)
{
    Variation variation;
    for (const auto& [name, value] : values)
        variation.parameters[name] = value;
    for (const auto& [name, value] : variation.parameters)
        variation.name += (variation.name.empty() ? "" : ", ") + name + "=" + value;
    return variation;
}

/// Every combination of the choices, the last distribution changing fastest.
std::vector<Variation> parseAllDeterministic(ElementReader reader)
{
    std::vector<ParameterValues> combinations(1);
    for (pugi::xml_node node : reader.node.children())
    {
        if (node.type() != pugi::node_element || reader.context.isStopped()) continue;
        const std::vector<ParameterValues> choices = parseDeterministic({reader.context, node});
        if (choices.empty()) continue; // told already: the parameter keeps its own value
        if (combinations.size() * choices.size() > kMostVariations)
        {
            reader.context.invalid(node, "there are more than 100000 variations", "give fewer values");
            return {};
        }
        std::vector<ParameterValues> longer;
        for (const ParameterValues& combination : combinations)
            for (const ParameterValues& choice : choices)
            {
                longer.push_back(combination);
                longer.back().insert(longer.back().end(), choice.begin(), choice.end());
            }
        combinations = std::move(longer);
    }
    std::vector<Variation> variations;
    for (const ParameterValues& values : combinations)
        variations.push_back(variationOf(values));
    return variations;
}

std::vector<Variation> parseAllStochastic(ElementReader reader, std::optional<std::uint64_t> given)
{
    const int runs = reader.count("numberOfTestRuns", 1);
    const std::uint64_t ownSeed =
        static_cast<std::uint64_t>(std::llround(reader.numberOr("randomSeed", 0.0)));
    const std::uint64_t seed = given.value_or(ownSeed);
    if (runs < 1 || static_cast<std::size_t>(runs) > kMostVariations)
        reader.context.invalid(reader.node, "Stochastic/numberOfTestRuns is not from 1 to 100000",
                               "write such a number");
    reader.allowChildren({"StochasticDistribution"});
    std::vector<StochasticDistribution> distributions;
    for (pugi::xml_node node : reader.node.children("StochasticDistribution"))
        distributions.push_back(parseStochastic({reader.context, node}));
    if (static_cast<double>(runs) * static_cast<double>(distributions.size()) > kMostValues)
    {
        reader.context.invalid(reader.node, "there are more than 100000 values to draw",
                               "ask for fewer runs");
        return {};
    }
    std::vector<Variation> variations;
    for (int run = 0; run < runs && static_cast<std::size_t>(runs) <= kMostVariations; ++run)
    {
        ParameterValues values;
        for (const StochasticDistribution& distribution : distributions)
        {
            RandomDraw random(seed, distribution.parameter, static_cast<std::uint64_t>(run));
            if (distribution.draw) values.emplace_back(distribution.parameter, distribution.draw(random));
        }
        variations.push_back(variationOf(values));
    }
    return variations;
}

foundation::Result<std::optional<VariationSet>> parseSet(const XmlSource& source, const ParseOptions& options,
                                                         std::optional<std::uint64_t> seed)
{
    const pugi::xml_node root = source.root().child("ParameterValueDistribution");
    if (std::string_view(source.root().name()) != "OpenSCENARIO" || !root)
        return std::optional<VariationSet>();
    CatalogShelf shelf(std::nullopt);
    ParseContext context(options, source, shelf);
    ElementReader(context, source.root()).allowChildren({"FileHeader", "ParameterValueDistribution"});
    parseHeader(ElementReader(context, source.root()).child("FileHeader"));
    ElementReader reader(context, root);
    reader.allowChildren({"ScenarioFile", "Deterministic", "Stochastic"});
    VariationSet set;
    set.scenario = reader.child("ScenarioFile").text("filepath");
    if (const pugi::xml_node node = root.child("Stochastic"))
        set.variations = parseAllStochastic({context, node}, seed);
    else
        set.variations = parseAllDeterministic(reader.child("Deterministic"));
    reportUnread(context, source.root());
    if (context.isStopped()) return context.problems.front().error;
    set.problems = std::move(context.problems);
    set.elements = std::move(context.elements);
    return std::optional<VariationSet>(std::move(set));
}

} // namespace

foundation::Result<std::optional<VariationSet>> readVariations(const std::filesystem::path& file,
                                                               const ParseOptions& options,
                                                               std::optional<std::uint64_t> seed)
{
    foundation::Result<std::unique_ptr<XmlSource>> source = XmlSource::read(file, options.maximumBytes);
    if (!source) return source.error();
    return parseSet(**source, options, seed);
}

foundation::Result<std::optional<VariationSet>> parseVariations(std::string_view text,
                                                                const std::string& name,
                                                                const ParseOptions& options,
                                                                std::optional<std::uint64_t> seed)
{
    foundation::Result<std::unique_ptr<XmlSource>> source = XmlSource::parse(text, name);
    if (!source) return source.error();
    return parseSet(**source, options, seed);
}

} // namespace simulation
