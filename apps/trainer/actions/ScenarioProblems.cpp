// SPDX-License-Identifier: Apache-2.0
#include "ScenarioProblems.h"

#include <iostream>
#include <map>
#include <utility>

namespace trainer
{

foundation::Outcome tellProblems(const std::vector<simulation::Problem>& problems)
{
    std::map<std::pair<std::string, std::string>, int> counts;
    for (const simulation::Problem& problem : problems)
    {
        if (problem.kind == simulation::Problem::Kind::invalid) return problem.error;
        ++counts[{problem.error.what, problem.error.remedy}];
    }
    for (const simulation::Problem& problem : problems)
    {
        const int count = std::exchange(counts[{problem.error.what, problem.error.remedy}], 0);
        if (count == 0) continue;
        std::cerr << "warning: " << problem.error.message();
        if (count > 1) std::cerr << " (and " << count - 1 << " more)";
        std::cerr << '\n';
    }
    return foundation::success();
}

foundation::Outcome tellRecordings(simulation::Scenario& scenario, const simulation::RecordingPlace& place)
{
    const auto notes = simulation::layRecordings(scenario, place);
    if (!notes) return notes.error();
    for (const std::string& note : *notes)
        std::cout << "track: " << note << '\n';
    return foundation::success();
}

void tellWarnings(const simulation::ScenarioPlayer& player)
{
    for (const foundation::Error& warning : player.warnings())
        std::cerr << "warning: " << warning.message() << '\n';
}

} // namespace trainer
