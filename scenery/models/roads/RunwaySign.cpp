// SPDX-License-Identifier: Apache-2.0
// Source: ICAO Annex 14, 8th edition, 5.4.2, table 5-5 (heights), appendix 4 (letters).
#include <algorithm>

#include "scenery/models/roads/RoadModelParts.h"
#include "scenery/models/roads/SignPainter.h"

namespace scenery::models
{

namespace
{

constexpr double kHousingM = 0.24, kRimM = 0.03, kSheetM = 0.01, kLegM = 0.04;
constexpr double kCellShare = 0.65;  ///< of the face's height, of which a letter has three quarters
constexpr double kStepOfCell = 0.66; ///< from letter to letter, of a cell's width

/// Adds letters in front of the face: of each cell the middle alone, so that they stand close.
void addLetters(ModelBuilder& builder, const std::string& text, double middleM, double cellM)
{
    const double stepM = kStepOfCell * cellM;
    double leftM = 0.5 * stepM * static_cast<double>(text.size());
    for (const char letter : text)
    {
        const double rightM = leftM - stepM;
        const SignCell cell = cellOfRunwayGlyph(letter);
        const float aside = 0.5F * static_cast<float>(1.0 - kStepOfCell) * (cell.high.x - cell.low.x);
        if (letter == '-')
            box(builder, {-2.0 * kSheetM, rightM + 0.2 * stepM, middleM - 0.05 * cellM},
                {-kSheetM, leftM - 0.2 * stepM, middleM + 0.05 * cellM});
        else
            addBox(builder, {{-2.0 * kSheetM, rightM, middleM - 0.5 * cellM},
                             {-kSheetM, leftM, middleM + 0.5 * cellM},
                             {cell.high.x - aside, cell.low.y},
                             {cell.low.x + aside, cell.high.y},
                             1.0F});
        leftM = rightM;
    }
}

} // namespace

/// Adds a box on two legs, whose front is white letters in a red ground.
void addRunwaySign(ModelBuilder& builder, const RoadModel& model)
{
    const double heightM = orElse(model.heightM, 0.8), lowM = orElse(model.raisedM, 0.3),
                 cellM = kCellShare * heightM;
    const double textM = kStepOfCell * cellM * static_cast<double>(model.text.size() + 1);
    const double halfM = 0.5 * std::max(orElse(model.widthM, 2.4 * heightM), textM);
    builder.begin("housing", kPlain, {0.16F, 0.16F, 0.17F});
    box(builder, {0.0, -halfM, lowM}, {kHousingM, halfM, lowM + heightM});
    builder.begin("face", kLitPlain, glm::vec3(SignPainter::kRed));
    box(builder, {-kSheetM, kRimM - halfM, lowM + kRimM}, {0.0, halfM - kRimM, lowM + heightM - kRimM});
    builder.begin("letters", kLitPlain);
    addLetters(builder, model.text, lowM + 0.5 * heightM, cellM);
    builder.begin("legs", kPlain, kZinc);
    for (const double side : {-0.7, 0.7})
        bar(builder, {0.5 * kHousingM, side * halfM, -model.postDepthM},
            {0.5 * kHousingM, side * halfM, lowM}, kLegM);
}

} // namespace scenery::models
