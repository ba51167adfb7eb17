// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a data file of an aircraft of JSBSim, and any line may come back from its
// process: both are read or refused. The bytes are a data file, and, by themselves, a table: its first line
// the captions, the others rows.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "simulation/vehicle/jsbsim/JsbsimFile.h"
#include "simulation/vehicle/jsbsim/JsbsimRow.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace simulation;

void require(bool condition)
{
    if (!condition) std::abort();
}

std::string_view takeLine(std::string_view& text)
{
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

void readFile(std::string_view text)
{
    const auto data = parseJsbsimAircraft(text, "fuzz");
    if (!data)
        return require(!data.error().what.empty() && data.error().message().find('\n') == std::string::npos);
    require(!data->aircraft.empty() && !data->program.empty());
    require(data->answersWithinS >= 0.01 && data->answersWithinS <= 600.0);
}

void readTable(std::string_view text)
{
    const std::vector<std::string> more{"ap/heading_hold", "fcs/no-such"};
    const auto table = JsbsimTable::create(takeLine(text), more);
    if (!table) return;
    while (!text.empty())
    {
        const auto row = table->read(takeLine(text));
        if (!row) continue;
        require(row->more.size() == more.size());
        bool isFinite = true;
        for (const double value : row->values)
            isFinite = isFinite && std::isfinite(value);
        require(row->isFinite() == isFinite);
    }
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    readFile(text);
    readTable(text);
    return 0;
}
