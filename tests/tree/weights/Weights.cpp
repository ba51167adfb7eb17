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
    std::vector<std::vector<std::string>> names;
    for (const char* list : {"demo.txt", "all.txt", "headers.txt", "system.txt", "read.txt"})
    {
        auto found = readList(lists / list);
        if (!found) return found.error();
        if (found->empty())
            return foundation::Error{(lists / list).string(), "lists nothing",
                                     "build the tree first (./check)"};
        names.push_back(std::move(*found));
    }
    std::vector<std::string>& folders = units->folders;
    folders.insert(folders.end(), names[3].begin(), names[3].end());
    Weights weights{IncludeGraph(folders, root, overlay, {names[4].begin(), names[4].end()}), {}, {}, {}};
    const std::set<std::string> demoObjects(names[0].begin(), names[0].end()),
        allObjects(names[1].begin(), names[1].end());
    for (const Unit& unit : units->units)
    {
        const bool demo = demoObjects.contains(unit.object);
        if (!demo && !allObjects.contains(unit.object)) continue;
        const IncludeGraph::File file = weights.graph.find(unit.source);
        const Weighed weighed{unit.object, file < 0 ? 0 : weights.graph.weight(file)};
        weights.all.push_back(weighed);
        if (demo) weights.demo.push_back(weighed);
    }
    for (const std::string& header : names[2])
        if (const IncludeGraph::File file = weights.graph.find((root / header).string()); file >= 0)
            weights.headers.emplace_back(header, weights.graph.weight(file));
    for (auto* list : {&weights.demo, &weights.all, &weights.headers})
        heaviestFirst(*list);
    return weights;
}
