// SPDX-License-Identifier: Apache-2.0
#include "scenery/clouds/CloudVolumeBytes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/PlainBytes.h>

namespace scenery::clouds
{

namespace
{

/// Base, top, extinction and sharpness.
using VolumeNumbers = std::array<double, 4>;

bool areOfALayer(const VolumeNumbers& numbers)
{
    const bool areFinite =
        std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
    return areFinite && numbers[1] > numbers[0] && numbers[2] >= 0.0 && numbers[3] >= 0.0;
}

} // namespace

std::string bytesOf(const CloudVolume& volume)
{
    std::string bytes;
    foundation::appendValue(
        bytes, VolumeNumbers{volume.baseM, volume.topM, volume.extinctionPerM, volume.sharpness});
    for (const auto* const samples : {&volume.form, &volume.gap, &volume.skylit})
        foundation::appendValues(bytes, *samples);
    return bytes;
}

std::optional<CloudVolume> cloudVolumeIn(std::string_view bytes)
{
    constexpr std::size_t kSamples =
        std::size_t{CloudVolume::kSide} * CloudVolume::kSide * CloudVolume::kSlices;
    foundation::ValueTaker taker(bytes);
    VolumeNumbers numbers{};
    if (!taker.take(numbers) || !areOfALayer(numbers)) return std::nullopt;
    CloudVolume volume;
    volume.baseM = numbers[0];
    volume.topM = numbers[1];
    volume.extinctionPerM = numbers[2];
    volume.sharpness = static_cast<float>(numbers[3]);
    for (auto* const samples : {&volume.form, &volume.gap, &volume.skylit})
        if (!taker.take(*samples) || samples->size() != kSamples) return std::nullopt;
    return taker.isEmpty() ? std::optional(std::move(volume)) : std::nullopt;
}

} // namespace scenery::clouds
