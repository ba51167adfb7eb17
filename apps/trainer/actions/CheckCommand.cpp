// SPDX-License-Identifier: Apache-2.0
#include "CheckCommand.h"

#include <array>
#include <iostream>
#include <map>
#include <set>

#include <foundation/WholeFile.h>
#include <nlohmann/json.hpp>

#include "osgSession/src/core/SteppedScenario.h"
#include "simulation/parser/Coverage.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/parser/Variations.h"
#include "simulation/track/LayRecordings.h"
#include "terminal/Terminal.h"

namespace trainer
{
namespace
{

using simulation::Problem;
using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 5> kKinds = {"approximated", "not supported", "unknown", "assumed",
                                               "wrong"};
constexpr std::array<const char*, 4> kSupport = {"played", "passedOver", "approximated", "notInEffect"};

struct Finding
{
    std::vector<Problem> problems;
    std::map<std::string, int> elements;
    bool isUnreadable = false;
};

/// Adds what refers to roads, lanes, files or elements that are not there, as a play without a terrain would
/// find it.
void addReferences(Finding& finding, const std::filesystem::path& file, simulation::Scenario scenario)
{
    const auto add = [&](Problem::Kind kind, const foundation::Error& error) {
        finding.problems.push_back({kind, error});
    };
    const auto ground =
        osgSession::core::openScenarioGround(scenario, file, simulation::WithoutRoads::played);
    if (!ground) return add(Problem::Kind::invalid, ground.error());
    if (const auto& scene = ground->missing.scene) add(Problem::Kind::unsupported, *scene);
    if (const auto& roads = ground->missing.roads) return add(Problem::Kind::invalid, *roads);
    if (ground->roads)
        for (const foundation::Error& mistake : ground->roads->mistakes()) // of the roads, not the scenario
            add(Problem::Kind::approximated, mistake);
    const auto player = osgSession::core::makePlayer(std::move(scenario), file, *ground,
                                                     simulation::FixedClock::forStep(0.01), 0);
    if (!player) return add(Problem::Kind::invalid, player.error());
    for (const foundation::Error& warning : (*player)->warnings())
        add(Problem::Kind::invalid, warning);
}

/// Adds what the scenario has. A file that cannot be read at all is one problem.
void add(Finding& finding, const std::filesystem::path& scenario,
         const std::map<std::string, std::string>& parameters)
{
    auto parsed = simulation::readScenario(scenario, {.tolerant = true, .parameters = parameters});
    if (!parsed)
    {
        finding.problems.push_back({Problem::Kind::invalid, parsed.error()});
        finding.isUnreadable = true;
        return;
    }
    finding.problems.insert(finding.problems.end(), parsed->problems.begin(), parsed->problems.end());
    finding.elements = std::move(parsed->elements);
    if (const auto laid = simulation::layRecordings(parsed->scenario, {scenario}); !laid)
        return finding.problems.push_back({Problem::Kind::invalid, laid.error()});
    addReferences(finding, scenario, std::move(parsed->scenario));
}

/// A file of distributions is checked with its scenario in every variation; what they share is told once.
Finding find(const std::filesystem::path& file)
{
    Finding finding;
    auto set = simulation::readVariations(file, {.tolerant = true, .parameters = {}});
    if (!set || !*set) return add(finding, file, {}), finding;
    for (const simulation::Variation& variation : (*set)->variations)
        add(finding, file.parent_path() / (*set)->scenario, variation.parameters);
    finding.elements = std::move((*set)->elements);
    std::vector<Problem> all = std::move((*set)->problems);
    all.insert(all.end(), finding.problems.begin(), finding.problems.end());
    std::set<std::string> told;
    finding.problems.clear();
    for (Problem& problem : all)
        if (told.insert(problem.error.message()).second) finding.problems.push_back(std::move(problem));
    return finding;
}

bool isWrong(const Problem& problem, bool isStrict)
{
    return isStrict || problem.kind >= Problem::Kind::unknown;
}

Json jsonOf(const std::filesystem::path& scenario, const Finding& finding)
{
    Json elements = Json::object();
    for (const char* support : kSupport)
        elements[support] = Json::object();
    for (const auto& [name, count] : finding.elements)
        if (const auto* row = simulation::coverageOf(name))
            elements[kSupport.at(static_cast<std::size_t>(row->support))][name] = count;
    Json problems = Json::array();
    for (const Problem& problem : finding.problems)
        problems.push_back({{"kind", kKinds.at(static_cast<std::size_t>(problem.kind))},
                            {"place", problem.error.place},
                            {"what", problem.error.what},
                            {"remedy", problem.error.remedy}});
    return {{"file", scenario.string()}, {"elements", elements}, {"problems", problems}};
}

/// A file's name may hold any bytes; JSON holds UTF-8.
std::string textOf(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

int check(const CheckRequest& request)
{
    if (request.printsCoverage) return std::cout << simulation::coveragePage(), terminal::kDone;
    if (request.scenarios.empty())
        return terminal::fail("trainer", {"check", "no scenario is given", "name an OpenSCENARIO file"}),
               terminal::kWrongUse;
    if (const auto writable = foundation::checkWritable(request.jsonFile); !writable)
        return terminal::fail("trainer", writable.error());
    Json files = Json::array();
    std::size_t wrong = 0;
    for (const std::filesystem::path& scenario : request.scenarios)
    {
        const Finding finding = find(scenario);
        if (finding.isUnreadable && request.scenarios.size() == 1)
            return terminal::fail("trainer", finding.problems.front().error);
        for (const Problem& problem : finding.problems)
        {
            std::cout << problem.error.message() << '\n';
            wrong += isWrong(problem, request.isStrict) ? 1 : 0;
        }
        files.push_back(jsonOf(scenario, finding));
    }
    if (!request.jsonFile.empty())
        if (const auto written = foundation::writeWholeFile(request.jsonFile, textOf(files)); !written)
            return terminal::fail("trainer", written.error());
    if (wrong == 0) return terminal::kDone;
    const std::string place = request.scenarios.size() == 1
                                  ? request.scenarios.front().string()
                                  : std::to_string(request.scenarios.size()) + " files";
    return terminal::fail("trainer", {place, std::to_string(wrong) + (wrong == 1 ? " problem" : " problems"),
                                      "see the lines above"});
}

} // namespace trainer
