// SPDX-License-Identifier: Apache-2.0
// weights: the weight of the tree against its limits.
//   weights check LISTS ROOT LIMITS [OVERLAY]   fails where a limit is exceeded, and names what is heaviest
// weights propose LISTS ROOT LIMITS the same limits 4 % above what is measured, as a file of limits
//   weights list LISTS ROOT LIMITS              what each unit and each header weighs, heaviest first
//   weights raised LIMITS LIMITS                what the second file allows and the first did not
#include <algorithm>
#include <iostream>

#include "Limits.h"
#include "Weights.h"

namespace
{

constexpr double kAllowance = 1.04;
constexpr std::size_t kShown = 4;

int fail(const std::string& message)
{
    std::cerr << "weights: " << message << "\n";
    return 1;
}

/// What is measured under each name of a total.
std::map<std::string, long> totals(const Weights& weights)
{
    std::map<std::string, long> measured;
    for (const auto& [part, units] : weights.units)
    {
        measured[part + " units"] = static_cast<long>(units.size());
        measured[part + " lines"] = Weights::sum(units);
    }
    return measured;
}

/// The heaviest of the files that a header includes itself: what each brings, and the way to the largest file
/// behind it.
void printBrought(Weights& weights, const std::filesystem::path& root, const std::string& header)
{
    const IncludeGraph::File file = weights.graph.find((root / header).string());
    std::vector<std::pair<long, IncludeGraph::File>> brought;
    for (const auto& [each, by] : weights.graph.closure(file))
        if (by == file) brought.emplace_back(weights.graph.weight(each), each);
    std::ranges::sort(brought, std::greater());
    for (std::size_t i = 0; i < std::min<std::size_t>(2, brought.size()); ++i)
    {
        IncludeGraph::File largest = brought[i].second;
        for (const auto& [each, by] : weights.graph.closure(brought[i].second))
            if (weights.graph.lines(each) > weights.graph.lines(largest)) largest = each;
        std::cerr << "        " << brought[i].first << " lines by " << weights.graph.chain(file, largest)
                  << "\n";
    }
}

int checkTotals(const Weights& weights, const Limits& limits)
{
    int failures = 0;
    for (const auto& [name, measured] : totals(weights))
    {
        if (!limits.contains(name))
        {
            failures += fail("the limit '" + name + "' is missing; bring it back");
            continue;
        }
        std::cout << name << ": " << measured << " of " << limits.at(name) << "\n";
        if (measured <= limits.at(name)) continue;
        failures += fail("'" + name + "' is " + std::to_string(measured) + ", and may be " +
                         std::to_string(limits.at(name)) + "; the heaviest units:");
        const std::vector<Weighed>& units = weights.units.at(name.substr(0, name.find(' ')));
        for (std::size_t i = 0; i < std::min(kShown, units.size()); ++i)
            std::cerr << "    " << units[i].second << " " << units[i].first << "\n";
    }
    return failures;
}

int checkHeaders(Weights& weights, const std::filesystem::path& root, const Limits& limits)
{
    std::map<std::string, std::vector<Weighed>> exceeding;
    std::map<std::string, int> bound;
    int failures = 0;
    for (const Weighed& header : weights.headers)
    {
        const std::string name = headerLimit(limits, header.first);
        if (name.empty())
            failures += fail(header.first + ": no limit binds it; add one for its folder");
        else if (++bound[name]; header.second > limits.at(name))
            exceeding[name].push_back(header);
    }
    for (const auto& [name, headers] : exceeding)
    {
        failures += fail("'" + name + "' may bring " + std::to_string(limits.at(name)) +
                         " lines; too heavy: " + std::to_string(headers.size()));
        for (std::size_t i = 0; i < std::min(kShown, headers.size()); ++i)
        {
            const Weighed& lightest = headers[headers.size() - 1 - i]; // nearest to what grew
            std::cerr << "    " << lightest.first << " brings " << lightest.second << "\n";
            printBrought(weights, root, lightest.first);
        }
    }
    for (const auto& [name, limit] : limits)
        if (name.starts_with("header ") && !bound.contains(name))
            failures += fail("'" + name + "' binds no header; take it out, or correct the path");
    return failures;
}

int check(Weights& weights, const std::filesystem::path& root, const Limits& limits)
{
    const int failures = checkTotals(weights, limits) + checkHeaders(weights, root, limits);
    if (failures == 0) return 0;
    return fail("remedy: include less (declare a type forward, move the include into the source, keep what "
                "is heavy behind a pointer), merge targets; "
                "or raise the limit in tests/tree/weights.txt, with a line 'Weight: reason' in the commit");
}

int propose(const Weights& weights, const Limits& limits)
{
    std::map<std::string, long> measured = totals(weights);
    for (const auto& [header, lines] : weights.headers)
        if (const std::string name = headerLimit(limits, header); !name.empty())
            measured[name] = std::max(measured[name], lines);
    for (const auto& [name, lines] : measured)
        std::cout << name << " " << static_cast<long>(static_cast<double>(lines) * kAllowance) + 1 << "\n";
    return 0;
}

int list(const Weights& weights)
{
    for (const auto& [name, lines] : weights.units.at("all"))
        std::cout << "unit " << lines << " " << name << "\n";
    for (const auto& [name, lines] : weights.headers)
        std::cout << "header " << lines << " " << name << "\n";
    return 0;
}

} // namespace

int main(int count, char** words)
{
    const std::vector<std::string> arguments(words + 1, words + count);
    const std::string command = arguments.empty() ? "" : arguments[0];
    const bool comparing = command == "raised" && arguments.size() == 3;
    const bool weighing =
        (command == "check" || command == "propose" || command == "list") && arguments.size() >= 4;
    if (!comparing && !weighing)
        return fail(
            "usage: weights check|propose|list LISTS ROOT LIMITS [OVERLAY], weights raised LIMITS LIMITS");
    auto limits = readLimits(arguments[comparing ? 1 : 3]);
    if (!limits) return fail(limits.error().message());
    if (comparing)
    {
        auto after = readLimits(arguments[2]);
        if (!after) return fail(after.error().message());
        for (const std::string& line : raised(*limits, *after))
            std::cout << line << "\n";
        return 0;
    }
    auto weights = weigh(arguments[1], arguments[2], arguments.size() > 4 ? arguments[4] : "");
    if (!weights) return fail(weights.error().message());
    if (command == "list") return list(*weights);
    return command == "propose" ? propose(*weights, *limits) : check(*weights, arguments[2], *limits);
}
