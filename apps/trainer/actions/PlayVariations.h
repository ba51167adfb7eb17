// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include <foundation/Result.h>

namespace trainer
{

/// Which variations of a scenario are played.
struct VariationRequest
{
    std::optional<int> number;         ///< counted from 1; absent: all
    bool isListed = false;             ///< prints the names instead of playing
    std::optional<std::uint64_t> seed; ///< absent: the file's own
};

/// One scenario to play, with the values of its parameters.
struct ScenarioPlay
{
    std::filesystem::path scenario;
    std::map<std::string, std::string> parameters;
    std::string suffix; ///< for the files that it writes: "-1" …; empty where there is but one play
};

/// Plays a scenario, or the variations that a file of parameter-value distributions asks for, one after the
/// other.
/// Errors: as simulation::readVariations(); a number that there is not; what `play` returns, which ends it.
foundation::Outcome playVariations(const std::filesystem::path& file, const VariationRequest& request,
                                   const std::function<foundation::Outcome(const ScenarioPlay&)>& play);

} // namespace trainer
