// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/CloudLayer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include <foundation/LineCells.h>

namespace simulation
{
namespace
{

constexpr double kHighestM = 20000.0, kThinnestM = 50.0;
constexpr std::array<std::pair<std::string_view, CloudKind>, 4> kKinds{
    {{"cumulus", CloudKind::cumulus},
     {"stratocumulus", CloudKind::stratocumulus},
     {"stratus", CloudKind::stratus},
     {"cirrus", CloudKind::cirrus}}};

std::optional<double> numberIn(std::string_view cell)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
    return value;
}

std::optional<CloudLayer> layerIn(std::string_view text)
{
    const auto cells = foundation::lineCells(text);
    if (cells.size() != 4) return std::nullopt;
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                   [&](const auto& known) { return known.first == cells[1]; });
    const auto oktas = numberIn(cells[0]), base = numberIn(cells[2]), top = numberIn(cells[3]);
    if (kind == kKinds.end() || !oktas || !base || !top) return std::nullopt;
    const int eighths = static_cast<int>(*oktas);
    if (eighths != *oktas || eighths < 0 || eighths > 8) return std::nullopt;
    if (!(*base >= 0.0 && *top >= *base + kThinnestM && *top <= kHighestM)) return std::nullopt;
    return CloudLayer{kind->second, eighths, *base, *top};
}

} // namespace

foundation::Result<std::vector<CloudLayer>> readCloudLayers(std::string_view text, std::string_view place)
{
    std::vector<CloudLayer> layers;
    const std::string where(place);
    if (const auto cells = foundation::lineCells(text); cells.size() == 1 && cells[0] == "none")
        return layers;
    for (std::size_t at = 0; at <= text.size();)
    {
        const std::size_t end = std::min(text.find(';', at), text.size());
        const auto layer = layerIn(text.substr(at, end - at));
        if (!layer)
            return foundation::Error{
                where, "'" + std::string(text.substr(at, end - at)) + "' is no layer of clouds",
                "write OKTAS KIND BASE TOP, as in 4 cumulus 1200 2000: 0 to 8; cumulus, "
                "stratocumulus, stratus or cirrus; metres up to 20000, 50 or more apart"};
        layers.push_back(*layer);
        at = end + 1;
    }
    if (layers.size() > kMostCloudLayers)
        return foundation::Error{where, std::to_string(layers.size()) + " layers of clouds",
                                 "leave all but three out"};
    std::sort(layers.begin(), layers.end(),
              [](const CloudLayer& a, const CloudLayer& b) { return a.baseM < b.baseM; });
    for (std::size_t i = 1; i < layers.size(); ++i)
        if (layers[i].baseM < layers[i - 1].topM)
            return foundation::Error{where, "a layer of clouds begins below the top of the one under it",
                                     "give each heights of its own"};
    return layers;
}

std::vector<CloudLayer> defaultClouds(int oktas, bool falls)
{
    if (oktas <= 0) return {};
    if (falls) return {{CloudKind::stratus, oktas, 500.0, 1700.0}};
    if (oktas <= 4) return {{CloudKind::cumulus, oktas, 1200.0, 2100.0}};
    if (oktas < 8) return {{CloudKind::stratocumulus, oktas, 1000.0, 1500.0}};
    return {{CloudKind::stratus, oktas, 600.0, 1400.0}};
}

} // namespace simulation
