// SPDX-License-Identifier: Apache-2.0
#include "PlayVariations.h"

#include <iostream>

#include "ScenarioProblems.h"
#include "simulation/parser/Variations.h"

namespace trainer
{
namespace
{

foundation::Outcome checkNumber(const std::filesystem::path& file, std::optional<int> number,
                                std::size_t count)
{
    if (!number || (*number >= 1 && static_cast<std::size_t>(*number) <= count)) return foundation::success();
    return foundation::Error{file.string(), "there is no variation " + std::to_string(*number),
                             count == 0
                                 ? "play it without --variation: it has no parameter-value distributions"
                                 : "give a number from 1 to " + std::to_string(count)};
}

} // namespace

foundation::Outcome playVariations(const std::filesystem::path& file, const VariationRequest& request,
                                   const std::function<foundation::Outcome(const ScenarioPlay&)>& play)
{
    const auto read = simulation::readVariations(file, {.tolerant = true, .parameters = {}}, request.seed);
    if (!read) return read.error();
    if (!*read)
    {
        if (const auto sound = checkNumber(file, request.number, 0); !sound) return sound;
        if (request.isListed)
            return std::cout << file.string() << " has no variations\n", foundation::success();
        return play({file, {}, ""});
    }
    const simulation::VariationSet& set = **read;
    if (const auto sound = tellProblems(set.problems); !sound) return sound;
    if (const auto sound = checkNumber(file, request.number, set.variations.size()); !sound) return sound;
    for (std::size_t i = 0; i < set.variations.size(); ++i)
    {
        const std::string number = std::to_string(i + 1);
        if (request.number && *request.number != static_cast<int>(i + 1)) continue;
        std::cout << "variation " << number << " of " << set.variations.size() << ": "
                  << set.variations[i].name << std::endl;
        if (request.isListed) continue;
        const ScenarioPlay one{file.parent_path() / set.scenario, set.variations[i].parameters,
                               request.number ? "" : "-" + number};
        if (const auto played = play(one); !played) return played;
    }
    return foundation::success();
}

} // namespace trainer
