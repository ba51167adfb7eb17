// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/trees/Skeleton.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace scenery::models
{

namespace
{

constexpr double kGoldenAngle = 2.39996322972865332;
constexpr int kTrunkPoints = 13;

double in(const Range& range, Dice& dice)
{
    return dice.between(range.low, range.high);
}

glm::dvec3 heading(double azimuth, double elevation)
{
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

/// Returns the point at a share of a limb's length, and the radius there.
std::pair<glm::dvec3, double> pointOf(const Limb& limb, double share)
{
    const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(limb.line.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), limb.line.size() - 2);
    const double t = at - static_cast<double>(i);
    return {glm::mix(limb.line[i], limb.line[i + 1], t), glm::mix(limb.radiiM[i], limb.radiiM[i + 1], t)};
}

Limb growTrunk(const TreeForm& form, double heightM, int number, Dice& dice)
{
    Limb trunk;
    const double phase = dice.between(0.0, 2.0 * std::numbers::pi);
    const double lean = form.stems > 1 ? 0.45 : 0.0;
    const double leanTurn = kGoldenAngle * number;
    const double stemTop = form.trunkTo * heightM * (form.stems > 1 ? dice.between(0.7, 1.0) : 1.0);
    for (int i = 0; i < kTrunkPoints; ++i)
    {
        const double t =
            std::pow(static_cast<double>(i) / (kTrunkPoints - 1), 1.35); // more points near the root
        const double z = -kRootM + t * (stemTop + kRootM);
        const double wander = form.trunkWander * heightM * t;
        glm::dvec3 place(wander * std::sin(5.0 * t + phase), wander * std::cos(4.1 * t + phase), z);
        place += glm::dvec3(std::cos(leanTurn), std::sin(leanTurn), 0.0) *
                 (lean * std::max(z, 0.0) * (1.0 - 0.4 * t));
        const double taper = std::pow(1.0 - t, 0.75);
        const double flare = 1.0 + 0.55 * std::exp(-std::max(z, 0.0) / (0.035 * heightM));
        trunk.line.push_back(place);
        trunk.radiiM.push_back(i + 1 == kTrunkPoints ? 0.0 : form.trunkRadius * heightM * taper * flare);
    }
    return trunk;
}

Limb growBough(const TreeForm& form, const Crown& crown, const glm::dvec3& from, double radiusM,
               double azimuth, Dice& dice)
{
    const double share = std::clamp(crown.shareOf(from.z), 0.0, 1.0);
    double elevation =
        glm::radians(glm::mix(form.boughElevationDeg.low, form.boughElevationDeg.high, share)) +
        dice.between(-0.14, 0.14);
    Limb bough{{from}, {radiusM}};
    const int most = 7;
    const double width = crown.radiusM * std::max(crown.profile(share), 0.12);
    const double step =
        std::max(width / std::max(std::cos(elevation), 0.30), 0.25 * crown.radiusM) / (most - 1.5);
    const double reach = dice.between(0.82, 0.98);
    for (int i = 1; i < most; ++i)
    {
        azimuth += dice.between(-0.16, 0.16);
        elevation += form.boughBend * 1.57 / most + dice.between(-0.09, 0.09);
        const glm::dvec3 next = bough.line.back() + heading(azimuth, elevation) * step;
        if (i > 2 && crown.depthOf(next) > reach) break;
        bough.line.push_back(next);
    }
    for (std::size_t i = 1; i < bough.line.size(); ++i)
        bough.radiiM.push_back(
            radiusM *
            std::pow(1.0 - static_cast<double>(i) / static_cast<double>(bough.line.size() - 1), 0.8));
    return bough;
}

void growTwigs(const TreeForm& form, const Crown& crown, const Limb& bough, std::vector<Limb>& twigs,
               Dice& dice)
{
    const double length = glm::distance(bough.line.front(), bough.line.back());
    for (int k = 0; k < form.twigsPerBough; ++k)
    {
        const double share = 0.25 + 0.72 * (k + dice.unit()) / form.twigsPerBough;
        const auto [from, radius] = pointOf(bough, share);
        const glm::dvec3 along = glm::normalize(bough.line.back() - bough.line.front());
        const glm::dvec3 side =
            glm::normalize(glm::cross(along, glm::dvec3(0, 0, 1)) + glm::dvec3(1e-3, 0, 0));
        const double spread =
            glm::radians(form.twigSpreadDeg) * dice.between(0.7, 1.25) * (k % 2 == 0 ? 1.0 : -1.0);
        const double lift = dice.between(-0.5, 0.85);
        glm::dvec3 direction = glm::normalize(along * std::cos(spread) + side * std::sin(spread) +
                                              glm::dvec3(0, 0, lift * std::abs(std::sin(spread))));
        const double reach = length * dice.between(0.22, 0.40);
        Limb twig{{from}, {std::max(0.55 * radius, 0.004)}};
        for (int i = 1; i <= 3; ++i)
        {
            direction = glm::normalize(direction + glm::dvec3(dice.between(-0.2, 0.2),
                                                              dice.between(-0.2, 0.2), 0.5 * form.boughBend));
            const glm::dvec3 next = twig.line.back() + direction * (reach / 3.0);
            if (i > 1 && crown.depthOf(next) > 1.0) break;
            twig.line.push_back(next);
            twig.radiiM.push_back(twig.radiiM.front() * (1.0 - i / 3.0));
        }
        twig.radiiM.back() = 0.0;
        twigs.push_back(std::move(twig));
    }
}

} // namespace

double Crown::depthOf(const glm::dvec3& place) const
{
    const double share = shareOf(place.z);
    if (share >= 1.0) return 1.5;
    return std::hypot(place.x, place.y) / (radiusM * std::max(profile(std::max(share, 0.0)), 0.02));
}

glm::vec3 Crown::normalAt(const glm::dvec3& place) const
{
    const double half = 0.5 * (topM - baseM);
    const double up = (place.z - baseM - 0.8 * half) / half;
    const glm::dvec3 outward(place.x / radiusM, place.y / radiusM,
                             0.75 * up * radiusM / std::max(half, radiusM) + 0.30);
    return glm::vec3(glm::normalize(outward));
}

Skeleton growSkeleton(const TreeForm& form, Dice& dice)
{
    Skeleton tree;
    tree.heightM = in(form.heightM, dice);
    tree.crown = {in(form.crownFrom, dice) * tree.heightM, tree.heightM,
                  in(form.crownRadius, dice) * tree.heightM, form.profile};
    for (int stem = 0; stem < form.stems; ++stem)
        tree.trunks.push_back(growTrunk(form, tree.heightM, stem, dice));
    const double turn = dice.between(0.0, 6.28);
    for (int k = 0; k < form.boughs; ++k)
    {
        const Limb& trunk = tree.trunks[static_cast<std::size_t>(k % form.stems)];
        const double wanted =
            glm::mix(tree.crown.baseM, 0.95 * form.trunkTo * tree.heightM, (k + dice.unit()) / form.boughs);
        double share = 0.0; // share of the trunk's length at that height
        while (share < 0.97 && pointOf(trunk, share).first.z < wanted)
            share += 0.01;
        const auto [from, radius] = pointOf(trunk, share);
        const double boughRadius = std::clamp(0.5 * radius, 0.006, 0.055 * tree.crown.radiusM);
        tree.boughs.push_back(growBough(form, tree.crown, from, boughRadius, turn + kGoldenAngle * k, dice));
        growTwigs(form, tree.crown, tree.boughs.back(), tree.twigs, dice);
    }
    return tree;
}

} // namespace scenery::models
