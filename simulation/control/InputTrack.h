// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

namespace simulation
{

/// What an input of InputTrack is where nothing is said of it.
inline constexpr double kInputNotGiven = -1e300;

/// The inputs of a vehicle over its steps or over time, as the inputs file has them
/// (docs/reference/inputs-file.md).
struct InputTrack
{
    /// Inputs from one step or time on.
    struct Row
    {
        double at = 0.0;            ///< steps since the start, or seconds
        std::vector<double> values; ///< in the order of names; kInputNotGiven: the vehicle's own
    };

    int stepsPerSecond = 0; ///< of the vehicle that was recorded; 0: rows count seconds
    bool isRamped = false;  ///< between rows inputs go straight from one to the next; else they hold
    std::vector<std::string> names;
    std::vector<Row> rows;     ///< at least one, ascending
    std::optional<double> end; ///< steps or seconds after which nothing more is said

    /// Where a step stands in `Row::at`. `stepS`: length of a step.
    double placeOf(std::int64_t step, double stepS) const
    {
        return stepsPerSecond > 0 ? static_cast<double>(step) : static_cast<double>(step) * stepS;
    }

    /// The inputs at a place; kInputNotGiven before the first row. `values`: as long as `names`.
    void valuesAt(double place, std::span<double> values) const;
};

/// Reads an inputs file. `name` stands for the file in errors.
/// Errors, with the line: no or another first line, an unknown word, a column without a name or with one
/// twice, a row with too many or too few cells, a cell that is no number, rows that do not ascend, no row,
/// more than 64 columns.
foundation::Result<InputTrack> parseInputs(std::string_view text, const std::string& name);

/// Reads an inputs file. Errors: besides those of parseInputs() a file that cannot be read or is larger than
/// 256 MiB.
foundation::Result<InputTrack> readInputs(const std::filesystem::path& file);

/// The text of an inputs file, which parseInputs() reads back as the same numbers.
std::string writeInputs(const InputTrack& track);

} // namespace simulation
