// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a map, as XML where they begin as XML does, else as PBF: it is read, or refused.
// Of a part of what is read the streets become a network on a hillside, and a part is a file that is joined
// first, too.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include <unistd.h>

#include "DearPart.h"
#include "worldmaking/map/JoinOsm.h"
#include "worldmaking/map/ReadOsm.h"
#include "worldmaking/streets/BuildStreets.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

constexpr std::size_t kJoinedOneOf = 32, kBuiltOneOf = 8; // both take far longer than reading

void require(bool condition)
{
    if (!condition) std::abort();
}

/// Ground within a tenth of a degree of the seeds' place.
std::optional<double> hillside(double latitudeDeg, double longitudeDeg)
{
    if (std::fabs(latitudeDeg - 42.5) > 0.1 || std::fabs(longitudeDeg - 1.5) > 0.1) return std::nullopt;
    return 1000.0 + 5000.0 * (latitudeDeg - 42.5) + 40.0 * std::sin(2000.0 * longitudeDeg);
}

std::string formatOf(std::string_view bytes)
{
    return bytes.starts_with('<') ? "osm" : "osm.pbf";
}

/// What is joined can be read.
void join(std::string_view bytes)
{
    const auto folder = std::filesystem::temp_directory_path() / ("fuzz-osm-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const auto file = folder / ("fuzz." + formatOf(bytes));
    std::ofstream(file, std::ios::binary) << bytes;
    worldmaking::JoinReport report;
    const worldmaking::MapSource source{file.string(), true};
    const auto joined = worldmaking::joinOsm({source, source}, folder / "joined.osm.pbf", report);
    if (joined)
    {
        const auto map = worldmaking::readOsm(*joined);
        require(map || map.error().message().find("no nodes") != std::string::npos);
        if (map)
            for (const auto& way : map->ways)
                require(way.id > 0 && way.nodes.size() >= 2);
    }
    std::filesystem::remove_all(folder);
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (isDearPartDone(size, kJoinedOneOf)) join(bytes);
    const auto map = worldmaking::parseOsm(bytes, formatOf(bytes), "fuzz");
    if (!map || !isDearPartDone(size, kBuiltOneOf)) return 0;
    const auto streets = worldmaking::buildStreets(*map, hillside, "fuzz");
    if (!streets) return 0;
    for (const auto& road : streets->network.roads)
    {
        require(std::isfinite(road.length) && road.length > 0.0);
        require(!road.referenceLine.isEmpty() && !road.sections.empty());
        require(std::isfinite(road.elevation.value(0.5 * road.length)));
    }
    return 0;
}
