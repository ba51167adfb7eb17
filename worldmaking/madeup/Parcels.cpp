// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Parcels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <foundation/ForEachAtOnce.h>

#include "scenery/buildings/Outline.h"
#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

using scenery::models::Dice;

constexpr double kLeastParcelM2 = 4000.0, kCornerM = 8.0, kBalkM = 1.5, kParcelSampleM = 30.0;
constexpr double kLargestM2 = 70000.0, kSmallestM2 = 12000.0;
constexpr double kLevelGround = 0.012; ///< gentler ground has no direction of its own
constexpr double kRealSlope = 0.05;    ///< from it on the ground alone says how a parcel lies
constexpr double kEstateM2 = 600000.0, kMostAskew = 0.35;
constexpr double kLongest = 2.6; ///< length to width, beyond which a parcel is cut across

struct ParcelSamples
{
    double meanSlope = 0.0, good = 0.0; ///< good: share that is land and wished for
};

/// Cuts land into parcels.
class Divider
{
public:
    explicit Divider(const ParcelRules& rules) : _rules(rules) {}

    void divide(const std::vector<glm::dvec2>& ring, Dice& dice)
    {
        if (ring.size() < 3) return;
        const double areaM2 = std::abs(scenery::turnedAreaOf(ring));
        if (areaM2 < kLeastParcelM2) return;
        if (areaM2 <= wantedM2(ring.front()) * dice.between(0.7, 1.3))
        {
            parcels.push_back(ring);
            return;
        }
        const auto box = scenery::rectangleAround(ring);
        const glm::dvec2 along = cutAlong(box, areaM2, dice);
        const glm::dvec2 through =
            box.middle + dice.between(-0.25, 0.25) * box.halfWidthM * glm::dvec2(-along.y, along.x);
        const auto [left, right] = cutRing(ring, through, along);
        divide(left, dice);
        divide(right, dice);
    }

    std::vector<std::vector<glm::dvec2>> parcels;

private:
    double wantedM2(const glm::dvec2& place) const
    {
        const double large = std::pow(noiseAt(place, 3500.0, seedFor(_rules.seed, 42)), 1.5);
        return kSmallestM2 + (kLargestM2 - kSmallestM2) * large;
    }

    /// Large land is cut across, somewhat askew; small land along the contour lines where it slopes, else
    /// along its own sides.
    glm::dvec2 cutAlong(const scenery::PlanRectangle& box, double areaM2, Dice& dice) const
    {
        const double askew = dice.between(-kMostAskew, kMostAskew);
        if (areaM2 > kEstateM2) return glm::normalize(box.across() + askew * box.along);
        const glm::dvec2 slope = _rules.ground.gradient(box.middle);
        if (box.halfLengthM > kLongest * box.halfWidthM) return box.across();
        if (glm::length(slope) < kLevelGround) return dice.chance(0.5) ? box.along : box.across();
        const glm::dvec2 contour = glm::normalize(glm::dvec2(-slope.y, slope.x));
        if (glm::length(slope) > kRealSlope) return contour;
        return std::abs(glm::dot(contour, box.along)) > 0.7 ? box.along : box.across();
    }

    const ParcelRules& _rules;
};

ParcelSamples samplesIn(const ParcelRules& rules, const std::vector<glm::dvec2>& ring)
{
    const MapBox box = boxOf(ring);
    const PlanRings rings{ring};
    ParcelSamples samples;
    int count = 0, good = 0;
    for (double y = box.low.y + 0.5 * kParcelSampleM; y < box.high.y; y += kParcelSampleM)
        for (double x = box.low.x + 0.5 * kParcelSampleM; x < box.high.x; x += kParcelSampleM)
        {
            const glm::dvec2 place(x, y);
            if (!scenery::isWithin(rings, place)) continue;
            ++count;
            samples.meanSlope += rules.ground.slope(place);
            good += rules.ground.isLand(place) && rules.wish(place) > 0.0;
        }
    if (count == 0) return {1.0, 0.0};
    return {samples.meanSlope / count, static_cast<double>(good) / count};
}

/// What is left of a parcel for fields.
std::vector<PlanRings> fieldsOn(const ParcelRules& rules, const std::vector<glm::dvec2>& ring)
{
    const ParcelSamples samples = samplesIn(rules, ring);
    if (samples.good < 0.6 || samples.meanSlope > kSteepestField) return {};
    const PlanArea area = PlanArea(PlanRings{ring})
                              .grown(-kBalkM)
                              .without(rules.taken(boxOf(ring)))
                              .grown(-kCornerM)
                              .grown(kCornerM);
    std::vector<PlanRings> fields;
    for (PlanRings& part : area.parts(kLeastParcelM2))
        if (samplesIn(rules, part.front()).meanSlope <= kSteepestField && part.size() == 1)
            fields.push_back(std::move(part));
    return fields;
}

} // namespace

std::pair<std::vector<glm::dvec2>, std::vector<glm::dvec2>>
cutRing(const std::vector<glm::dvec2>& ring, const glm::dvec2& through, const glm::dvec2& along)
{
    std::vector<glm::dvec2> left, right;
    const auto sideOf = [&](const glm::dvec2& point)
    { return along.x * (point.y - through.y) - along.y * (point.x - through.x); };
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const double sideA = sideOf(a), sideB = sideOf(b);
        (sideA >= 0.0 ? left : right).push_back(a);
        if ((sideA >= 0.0) == (sideB >= 0.0)) continue;
        const glm::dvec2 between = glm::mix(a, b, sideA / (sideA - sideB));
        left.push_back(between);
        right.push_back(between);
    }
    return {left, right};
}

std::vector<PlanRings> parcelsOn(const ParcelRules& rules)
{
    const MapBox& box = rules.ground.box();
    Divider divider(rules);
    Dice dice(seedFor(rules.seed, 41));
    divider.divide({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, dice);
    std::vector<std::vector<PlanRings>> found(divider.parcels.size());
    foundation::forEachAtOnce(found.size(),
                              [&](std::size_t i) { found[i] = fieldsOn(rules, divider.parcels[i]); });
    std::vector<PlanRings> fields;
    for (std::vector<PlanRings>& some : found)
        std::move(some.begin(), some.end(), std::back_inserter(fields));
    return fields;
}

} // namespace worldmaking
