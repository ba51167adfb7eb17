// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <utility>

#include "simulation/parser/Coverage.h"

namespace simulation
{
namespace
{

constexpr std::array<std::pair<Support, std::string_view>, 4> kWords = {
    {{Support::played, "played"},
     {Support::passive, "passed over"},
     {Support::approximated, "approximated"},
     {Support::reported, "not in effect"}}};

std::string_view supportWord(Support support)
{
    for (const auto& [value, word] : kWords)
        if (value == support) return word;
    return {};
}

std::string count(Support support)
{
    int rows = 0;
    for (const ElementCoverage& row : elementCoverage())
        rows += row.support == support ? 1 : 0;
    return std::to_string(rows);
}

} // namespace

std::string coveragePage()
{
    std::string page =
        "# Coverage of ASAM OpenSCENARIO XML\n\nEvery element of the versions 1.0 to 1.3, and what becomes "
        "of it. This page is "
        "printed by\n`build/bin/trainer check --coverage`, from the table that the reader itself uses "
        "(`simulation/parser/Coverage.cpp`). What is *approximated* or *not in\neffect* is a warning with "
        "file and line when a "
        "scenario has it, and the rest is played. What each element means here: "
        "[OpenSCENARIO](openscenario.md).\n\n";
    page += count(Support::played) + " elements are played, " + count(Support::passive) +
            " say nothing that could be played, " + count(Support::approximated) + " are approximated, " +
            count(Support::reported) + " are not in effect.\n";
    std::string_view part;
    for (const ElementCoverage& row : elementCoverage())
    {
        if (row.part != part)
            page += "\n## " + std::string(row.part) + "\n\n| element | | instead |\n|---|---|---|\n";
        part = row.part;
        page += "| `" + std::string(row.name) + "` | " + std::string(supportWord(row.support)) + " | " +
                std::string(row.instead) + " |\n";
    }
    return page;
}

} // namespace simulation
