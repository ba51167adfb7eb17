// SPDX-License-Identifier: Apache-2.0
// Rows of drums with figures behind a window, as of a mileage counter.
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/cockpit/InstrumentParts.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr int kDrumSides = 40;
const glm::vec3 kFrame(0.16F, 0.16F, 0.17F);

double drumRadiusM(double windowM)
{
    return windowM / (2.0 * std::tan(std::numbers::pi / kDrumFigures));
}

/// About the x axis; the figure 0 looks along z.
Model drumModel(double radiusM, double wideM, DrumColumn column)
{
    const InstrumentCell cell = cellOf(Instrument::digits);
    const float middle = column == DrumColumn::digits ? -0.5F : 0.5F;
    ModelBuilder builder;
    builder.begin("drum", kInstrumentSurface);
    std::vector<std::vector<Corner>> rows;
    for (int i = 0; i <= kDrumSides; ++i)
    {
        const double up =
            2.0 * std::numbers::pi * (static_cast<double>(i % kDrumSides) / kDrumSides - 0.5 / kDrumFigures);
        const auto v = static_cast<float>(2.0 * i / kDrumSides - 1.0);
        const glm::dvec3 out(0.0, std::sin(up), std::cos(up));
        std::vector<Corner>& row = rows.emplace_back();
        for (const double side : {-0.5, 0.5})
            row.push_back({radiusM * out + glm::dvec3(side * wideM, 0.0, 0.0),
                           cell.uvAt({middle + 0.24F * static_cast<float>(side), v}), out});
    }
    builder.grid(rows);
    return builder.finish();
}

Model frameModel(double wideM, double windowM)
{
    ModelBuilder builder;
    builder.begin("frame", kPlain, kFrame);
    const double half = 0.5 * windowM, rim = 0.7 * windowM;
    for (const double side : {-1.0, 1.0})
    {
        const double inner = side * half, outer = side * (half + rim);
        box(builder, {-0.5 * wideM - rim, std::min(inner, outer), -0.002},
            {0.5 * wideM + rim, std::max(inner, outer), 0.0015});
        const double end = side * 0.5 * wideM;
        box(builder, {std::min(end, end + side * rim), -half, -0.002},
            {std::max(end, end + side * rim), half, 0.0015});
    }
    return builder.finish();
}

} // namespace

void addDrums(InteriorModel& interior, const DrumRow& row, const glm::dmat4& entityFromPanel)
{
    const double radiusM = drumRadiusM(row.heightM), wideM = 0.8 * row.heightM;
    const glm::dmat4 window = glm::translate(entityFromPanel, row.middle);
    for (int drum = 0; drum < row.drums; ++drum)
    {
        const double asideM = wideM * (drum - 0.5 * (row.drums - 1));
        // The panel hides what is beside the figure.
        const glm::dmat4 axle = glm::translate(window, {asideM, 0.0, 0.1 * row.heightM - radiusM});
        const int place = static_cast<int>(std::lround(std::pow(10.0, row.drums - 1 - drum)));
        const auto number = row.number;
        interior.parts.push_back(
            {row.name + " drum", drumModel(radiusM, wideM, row.column), InteriorCoat::dial,
             [=](const Readings& readings)
             {
                 const int figure = std::abs(number(readings)) / place % kDrumFigures;
                 return glm::rotate(axle, 2.0 * std::numbers::pi * figure / kDrumFigures, {1.0, 0.0, 0.0});
             }});
    }
    interior.parts.push_back({row.name + " frame", frameModel(wideM * row.drums, row.heightM),
                              InteriorCoat::inside, [=](const Readings&) { return window; }});
}

} // namespace scenery::models
