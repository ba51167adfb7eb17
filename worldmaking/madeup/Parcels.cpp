// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Parcels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenery/buildings/Outline.h"
#include "worldmaking/madeup/Noise.h"

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

class Divider
{
public:
    Divider(const ParcelRules& rules, std::vector<PlanRings>& fields) : _rules(rules), _fields(fields) {}

    void divide(const std::vector<glm::dvec2>& ring, Dice& dice)
    {
        if (ring.size() < 3) return;
        const double areaM2 = std::abs(scenery::turnedAreaOf(ring));
        if (areaM2 < kLeastParcelM2) return;
        if (areaM2 > wantedM2(ring.front()) * dice.between(0.7, 1.3))
        {
            const auto box = scenery::rectangleAround(ring);
            const glm::dvec2 along = cutAlong(box, areaM2, dice);
            const glm::dvec2 through =
                box.middle + dice.between(-0.25, 0.25) * box.halfWidthM * glm::dvec2(-along.y, along.x);
            const auto [left, right] = cutRing(ring, through, along);
            divide(left, dice);
            divide(right, dice);
            return;
        }
        const ParcelSamples samples = look(ring);
        if (samples.good < 0.6 || samples.meanSlope > kSteepestField) return;
        const MapBox box = boxOf(ring);
        const PlanArea area = PlanArea(PlanRings{ring})
                                  .grown(-kBalkM)
                                  .without(_rules.taken(box))
                                  .grown(-kCornerM)
                                  .grown(kCornerM);
        for (PlanRings& part : area.parts(kLeastParcelM2))
            if (look(part.front()).meanSlope <= kSteepestField && part.size() == 1)
                _fields.push_back(std::move(part));
    }

private:
    double wantedM2(const glm::dvec2& place) const
    {
        const double large = std::pow(noiseAt(place, 3500.0, seedFor(_rules.seed, 42)), 1.5);
        return kSmallestM2 + (kLargestM2 - kSmallestM2) * large;
    }

    /// Large land is cut across, somewhat askew; small land along the contour lines where it slopes, else along its own sides.
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

    ParcelSamples look(const std::vector<glm::dvec2>& ring) const
    {
        const MapBox box = boxOf(ring);
        ParcelSamples samples;
        int count = 0, good = 0;
        for (double y = box.low.y + 0.5 * kParcelSampleM; y < box.high.y; y += kParcelSampleM)
            for (double x = box.low.x + 0.5 * kParcelSampleM; x < box.high.x; x += kParcelSampleM)
            {
                const glm::dvec2 place(x, y);
                if (!scenery::isWithin({ring}, place)) continue;
                ++count;
                samples.meanSlope += _rules.ground.slope(place);
                good += _rules.ground.isLand(place) && _rules.wish(place) > 0.0;
            }
        if (count == 0) return {1.0, 0.0};
        return {samples.meanSlope / count, static_cast<double>(good) / count};
    }

    const ParcelRules& _rules;
    std::vector<PlanRings>& _fields;
};

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
    std::vector<PlanRings> fields;
    const MapBox& box = rules.ground.box();
    Divider divider(rules, fields);
    Dice dice(seedFor(rules.seed, 41));
    divider.divide({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, dice);
    return fields;
}

} // namespace worldmaking
