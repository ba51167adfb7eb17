// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Woods.h"

#include <algorithm>
#include <cmath>

#include "worldmaking/madeup/Contours.h"
#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

constexpr float kNever = -10.0F;
constexpr double kLeastWoodM2 = 4000.0, kBankKm2 = 0.8;

double woodValueAt(const WoodRules& rules, const glm::dvec2& place)
{
    const double height = *rules.ground.heightM(place);
    const double slope = rules.ground.slope(place);
    const double high = std::max(0.0, height - rules.treeLineM + 150.0) / 300.0;
    const double banks = rules.drainage.areaKm2(place) > kBankKm2 ? 0.3 : 0.0;
    const double cliff = std::max(0.0, slope - 0.8);
    return roughNoiseAt(place, 1100.0, seedFor(rules.seed, 51)) + 1.2 * std::min(slope, 0.35) + banks -
           2.0 * high - 3.0 * cliff;
}

} // namespace

std::vector<PlanRings> woodsOn(const WoodRules& rules)
{
    const MapBox& box = rules.ground.box();
    const int columns = static_cast<int>((box.high.x - box.low.x) / kWoodCellM),
              rows = static_cast<int>((box.high.y - box.low.y) / kWoodCellM);
    std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), kNever);
    std::vector<float> land;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
        {
            const glm::dvec2 place = box.low + kWoodCellM * glm::dvec2(column + 0.5, row + 0.5);
            if (!rules.ground.isLand(place)) continue;
            const auto value = static_cast<float>(woodValueAt(rules, place));
            land.push_back(value);
            bool isFree = true;
            for (const double dy : {-0.5 * kWoodCellM, 0.0, 0.5 * kWoodCellM})
                for (const double dx : {-0.5 * kWoodCellM, 0.0, 0.5 * kWoodCellM})
                    isFree = isFree && !rules.isTaken(place + glm::dvec2(dx, dy));
            if (isFree)
                values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(column)] = value;
        }
    if (land.empty() || rules.share <= 0.0) return {};
    const auto wanted =
        static_cast<std::ptrdiff_t>((1.0 - rules.share) * static_cast<double>(land.size() - 1));
    std::nth_element(land.begin(), land.begin() + wanted, land.end());
    const float level = land[static_cast<std::size_t>(wanted)];
    for (float& value : values) // a step at what is taken: the outline stays with the last free square
        value = value == kNever ? 2.0F * level - 3.0F : std::max(value, level - 0.2F);
    return areasAbove(values, columns, box, kWoodCellM, level, kLeastWoodM2);
}

} // namespace worldmaking
