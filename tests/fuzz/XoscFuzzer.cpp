// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a scenario: they are read and written, a part of them is played, or refused.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "DearPart.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/writer/WriteScenario.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

constexpr int kSteps = 50;
constexpr std::size_t kPlayedOneOf = 16; // playing takes a hundred times as long as reading

simulation::PlayerOptions fuzzStage()
{
    simulation::PlayerOptions options;
    options.origin = simulation::Geodetic{46.5, 8.0, 0.0};
    options.clock = simulation::FixedClock(10);
    options.ground = [](double east, double north) -> std::optional<simulation::GroundSample>
    {
        if (!(std::fabs(east) < 1e4 && std::fabs(north) < 1e4)) return std::nullopt;
        return simulation::GroundSample{100.0 + 0.1 * east - 0.05 * north};
    };
    return options;
}

/// What the writer makes of a scenario must read back as the same.
void checkRoundTrip(const simulation::Scenario& scenario)
{
    const auto text = simulation::scenarioText(scenario);
    if (!text) return; // what moves on roads is played, but not written
    const auto again = simulation::parseScenario(*text, "again");
    if (!again) std::abort();
    simulation::Scenario expected = scenario;
    expected.header.revMajor = 1;
    expected.header.revMinor = 3;
    if (!(again->scenario == expected)) std::abort();
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const bool tolerant : {false, true})
    {
        simulation::ParseOptions options;
        options.tolerant = tolerant;
        const auto parsed = simulation::parseScenario(text, "fuzz", options);
        if (!parsed) continue;
        if (!tolerant && !parsed->scenario.isConsistent()) std::abort();
        if (!tolerant) checkRoundTrip(parsed->scenario);
        if (!isDearPartDone(size, kPlayedOneOf)) continue;
        auto player = simulation::ScenarioPlayer::create(parsed->scenario, fuzzStage());
        for (int i = 0; player && i < kSteps; ++i)
            (*player)->step();
    }
    return 0;
}
