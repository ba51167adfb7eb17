// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/CloudFigures.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace measurement
{

using scenery::clouds::CloudVolume;
using simulation::CloudKind;

namespace
{

constexpr double kSeenDepth = 0.1; ///< from which on a cloud is seen

std::string nameOf(CloudKind kind)
{
    switch (kind)
    {
    case CloudKind::cumulus:
        return "cumulus";
    case CloudKind::stratocumulus:
        return "stratocumulus";
    case CloudKind::stratus:
        return "stratus";
    default:
        return "cirrus";
    }
}

} // namespace

double oktasOf(const CloudVolume& volume)
{
    constexpr int kRays = 2000;
    std::mt19937 random(7);
    const auto anywhere = [&] { return static_cast<double>(random() % 2048000U) / 100.0; };
    int met = 0;
    for (int i = 0; i < kRays; ++i)
    {
        const double east = anywhere(), north = anywhere();
        met += opticalDepth(volume, {east, north, 0.0}, {0.0, 0.0, 1.0}) > kSeenDepth ? 1 : 0;
    }
    return 8.0 * met / kRays;
}

double lowestCloudM(const CloudVolume& volume)
{
    constexpr float kBegins = 0.1F; // of the density
    constexpr std::size_t kPlan = std::size_t{CloudVolume::kSide} * CloudVolume::kSide;
    std::vector<double> bases;
    for (std::size_t column = 0; column < kPlan; column += 7)
        for (int slice = 0; slice < CloudVolume::kSlices; ++slice)
            if (volume.density(slice * kPlan + column) > kBegins)
            {
                bases.push_back(volume.baseM + slice * volume.sliceM());
                break;
            }
    if (bases.empty()) return std::nan("");
    const auto tenth = bases.begin() + static_cast<std::ptrdiff_t>(bases.size() / 10);
    std::nth_element(bases.begin(), tenth, bases.end());
    return *tenth;
}

LightFigures cloudFigures(const CloudParts& parts)
{
    constexpr double kBaseM = 1000.0;
    LightFigures figures;
    for (const CloudKind cloud : parts.kinds)
    {
        const double depthM = cloud == CloudKind::cumulus ? 900.0 : 400.0;
        double worstOktas = 0.0, worstM = 0.0;
        for (int oktas = 0; oktas <= 8; ++oktas)
        {
            const CloudVolume volume = parts.make({cloud, oktas, kBaseM, kBaseM + depthM}, 1U);
            worstOktas = std::max(worstOktas, std::abs(oktasOf(volume) - oktas));
            if (oktas == 0) continue;
            const double offM = std::abs(lowestCloudM(volume) - kBaseM);
            worstM = offM <= worstM ? worstM : offM; // no number stays one
        }
        const std::string kind = nameOf(cloud);
        figures.push_back(atMost("N7", kind + ": cover, worst of 0 to 8 oktas", worstOktas, "oktas", 0.5,
                                 "the layer's oktas"));
        figures.push_back(atMost("N7", kind + ": base", worstM, "m", 20.0, "the layer's base"));
    }
    return figures;
}

} // namespace measurement
