// SPDX-License-Identifier: Apache-2.0
#include "Weights.h"

#include <algorithm>

#include "Units.h"

namespace
{

void heaviestFirst(std::vector<Weighed>& list)
{
    std::ranges::sort(list, [](const Weighed& a, const Weighed& b)
                      { return a.second != b.second ? a.second > b.second : a.first < b.first; });
}

} // namespace

long Weights::sum(const std::vector<Weighed>& units)
{
    long lines = 0;
    for (const auto& [name, weight] : units)
        lines += weight;
    return lines;
}

foundation::Result<Weights> weigh(const std::filesystem::path& lists, const std::filesystem::path& root,
                                  const std::filesystem::path& overlay)
{
    auto units = readUnits(lists);
    if (!units) return units.error();
    std::map<std::string, std::vector<std::string>> names;
    std::vector<const char*> wanted(kParts.begin(), kParts.end());
    wanted.insert(wanted.end(), {"headers", "system", "read"});
    for (const char* name : wanted)
    {
        const std::filesystem::path list = lists / (std::string(name) + ".txt");
        auto found = readList(list);
        if (!found) return found.error();
        if (found->empty())
            return foundation::Error{list.string(), "lists nothing", "build the tree first (./check --long)"};
        names.emplace(name, std::move(*found));
    }
    std::vector<std::string>& folders = units->folders;
    folders.insert(folders.end(), names["system"].begin(), names["system"].end());
    Weights weights{
        IncludeGraph(folders, root, overlay, {names["read"].begin(), names["read"].end()}), {}, {}};
    for (const char* part : kParts)
    {
        const std::set<std::string> objects(names[part].begin(), names[part].end());
        for (const Unit& unit : units->units)
        {
            if (!objects.contains(unit.object)) continue;
            const IncludeGraph::File file = weights.graph.find(unit.source);
            weights.units[part].emplace_back(unit.object, file < 0 ? 0 : weights.graph.weight(file));
        }
        heaviestFirst(weights.units[part]);
    }
    for (const std::string& header : names["headers"])
        if (const IncludeGraph::File file = weights.graph.find((root / header).string()); file >= 0)
            weights.headers.emplace_back(header, weights.graph.weight(file));
    heaviestFirst(weights.headers);
    return weights;
}
