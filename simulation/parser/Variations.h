// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "simulation/parser/ParseScenario.h"

namespace simulation
{

/// Values for the parameters of a scenario.
struct Variation
{
    std::string name; ///< the parameters with their values: "gap=12, speed=30"
    std::map<std::string, std::string> parameters;

    bool operator==(const Variation&) const = default;
};

/// What a file of parameter-value distributions asks to be played.
struct VariationSet
{
    std::filesystem::path scenario; ///< as the file names it, from the file's folder
    std::vector<Variation> variations;
    std::vector<Problem> problems; ///< empty after a strict reading
    std::map<std::string, int> elements;
};

/// Reads a file of parameter-value distributions; nothing: the file holds something else.
/// Deterministic distributions give every combination of their values, the last one changing fastest.
/// Stochastic ones give numberOfTestRuns variations; the value of a parameter depends on the seed, its name
/// and the number of the run alone, so each variation can be had again. `seed`: instead of the file's
/// randomSeed (without both: 0). At most 100 000 variations.
/// Errors: as readScenario().
/// Source: ASAM, *OpenSCENARIO XML* 1.3, "Parameter value distributions".
foundation::Result<std::optional<VariationSet>> readVariations(const std::filesystem::path& file,
                                                               const ParseOptions& options = {},
                                                               std::optional<std::uint64_t> seed = {});

/// The same from memory. `name` replaces the file.
foundation::Result<std::optional<VariationSet>> parseVariations(std::string_view text,
                                                                const std::string& name,
                                                                const ParseOptions& options = {},
                                                                std::optional<std::uint64_t> seed = {});

} // namespace simulation
