// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/cockpit/PaintInstruments.h"

#include <cmath>
#include <numbers>
#include <string>

#include <foundation/Angle.h>

#include "scenery/models/paint/Canvas.h"
#include "scenery/models/roads/StrokeFont.h"

namespace scenery::models
{

namespace
{

constexpr int kSizePx = 1024, kColumns = 4;
constexpr int kCellPx = kSizePx / kColumns;
const glm::vec4 kFace(0.045F, 0.045F, 0.05F, 0.0F), kMark(0.93F, 0.93F, 0.90F, 0.0F);

glm::vec2 around(double angleDeg)
{
    const double turn = foundation::radiansOf(angleDeg);
    return {static_cast<float>(std::sin(turn)), static_cast<float>(std::cos(turn))};
}

void paintArc(Canvas& canvas, const DialHand& hand, const DialArc& arc)
{
    constexpr int kPieces = 24;
    const double from = handAngleDeg(hand, arc.from), to = handAngleDeg(hand, arc.to);
    for (int i = 0; i < kPieces; ++i)
    {
        const auto at = [&](int k) { return 0.90F * around(from + (to - from) * k / kPieces); };
        canvas.stroke(at(i), at(i + 1), glm::vec2(0.07F), glm::vec4(arc.colour, 0.0F));
    }
}

/// The number as it stands on the dial; a card has letters at the quarters.
std::string textAt(const Dial& dial, double value)
{
    if (dial.hands.front().shape == DialHand::Shape::card && std::fmod(value, 90.0) == 0.0)
        return std::string(1, "NESW"[static_cast<int>(value / 90.0)]);
    return std::to_string(std::lround(std::abs(value) / dial.numberDivisor));
}

void paintNumber(Canvas& canvas, const Dial& dial, double value, double angleDeg)
{
    const bool isCard = dial.hands.front().shape == DialHand::Shape::card;
    StrokeText text;
    const std::string words = textAt(dial, value);
    text.text = words;
    text.middle = 0.62F * around(angleDeg);
    text.height = 0.19F;
    text.colour = kMark;
    if (isCard) text.turnRad = static_cast<float>(-foundation::radiansOf(angleDeg));
    paintText(canvas, text);
}

/// Steps of the scale from its first to its last value; a round one ends before its beginning.
int stepsOf(const DialHand& hand, double step)
{
    const double range = hand.scale.back().value - hand.scale.front().value;
    return static_cast<int>(std::lround(range / step)) - (hand.motion == DialMotion::round ? 1 : 0);
}

void paintScale(Canvas& canvas, const Dial& dial)
{
    const DialHand& hand = dial.hands.front();
    const auto marks = [&](double step, float inner, float width)
    {
        for (int i = 0; step > 0.0 && i <= stepsOf(hand, step); ++i)
        {
            const glm::vec2 out = around(hand.shape == DialHand::Shape::card
                                             ? i * step
                                             : handAngleDeg(hand, hand.scale.front().value + i * step));
            canvas.stroke(inner * out, 0.93F * out, glm::vec2(width), kMark);
        }
    };
    marks(dial.minorStep, 0.85F, 0.018F);
    marks(dial.majorStep, 0.78F, 0.03F);
    for (int i = 0; dial.numberStep > 0.0 && i <= stepsOf(hand, dial.numberStep); ++i)
    {
        const double value = hand.scale.front().value + i * dial.numberStep;
        paintNumber(canvas, dial, value,
                    hand.shape == DialHand::Shape::card ? value : handAngleDeg(hand, value));
    }
}

void paintLabel(Canvas& canvas, std::string_view words, const glm::vec2& middle, float height)
{
    StrokeText text;
    text.text = words;
    text.middle = middle;
    text.height = height;
    text.colour = kMark;
    paintText(canvas, text);
}

void paintDial(Canvas& canvas, const Dial& dial)
{
    canvas.disc({0.0F, 0.0F}, 1.0F, kFace);
    const DialHand& hand = dial.hands.front();
    for (const DialArc& arc : dial.arcs)
        paintArc(canvas, hand, arc);
    const bool isSmall = !dial.ends.empty();
    if (hand.shape == DialHand::Shape::aeroplane)
    {
        for (const double angleDeg : {-110.0, -90.0, 90.0, 110.0})
            canvas.stroke(0.78F * around(angleDeg), 0.93F * around(angleDeg), glm::vec2(0.05F), kMark);
        for (int i = -16; i <= 16; ++i)
            canvas.stroke(0.62F * around(180.0 + i), 0.62F * around(181.0 + i), glm::vec2(0.2F),
                          {0.75F, 0.75F, 0.72F, 0.0F});
        for (const double angleDeg : {175.0, 185.0})
            canvas.stroke(0.52F * around(angleDeg), 0.72F * around(angleDeg), glm::vec2(0.02F), kFace);
    }
    else
        paintScale(canvas, dial);
    paintLabel(canvas, dial.label, {0.0F, isSmall ? -0.45F : -0.34F}, isSmall ? 0.26F : 0.13F);
    for (std::size_t i = 0; i < dial.ends.size(); ++i)
        paintLabel(canvas, dial.ends.substr(i, 1), 0.66F * around(i == 0 ? -88.0 : 88.0), 0.30F);
}

/// The ball unrolled: across half a turn from left to right, upwards from the nadir to the zenith.
void paintBall(Canvas& canvas)
{
    const glm::vec4 sky(0.16F, 0.42F, 0.72F, 0.0F), soil(0.36F, 0.22F, 0.10F, 0.0F);
    canvas.rectangle({-1.04F, -1.04F}, {1.04F, 0.0F}, soil);
    canvas.rectangle({-1.04F, 0.0F}, {1.04F, 1.04F}, sky);
    canvas.rectangle({-1.04F, -0.012F}, {1.04F, 0.012F}, kMark);
    for (int deg = -60; deg <= 60; deg += 5)
    {
        const float up = static_cast<float>(deg) / 90.0F, half = deg % 10 == 0 ? 0.20F : 0.10F;
        if (deg != 0) canvas.rectangle({-half, up - 0.006F}, {half, up + 0.006F}, kMark);
    }
}

void paintDrums(Canvas& canvas)
{
    const std::string_view columns[] = {"0123456789", "RN12345678"};
    canvas.rectangle({-1.04F, -1.04F}, {1.04F, 1.04F}, kFace);
    for (int column = 0; column < 2; ++column)
        for (int i = 0; i < kDrumFigures; ++i)
            paintLabel(canvas, columns[column].substr(static_cast<std::size_t>(i), 1),
                       {column == 0 ? -0.5F : 0.5F, -0.9F + 0.2F * static_cast<float>(i)}, 0.15F);
}

} // namespace

InstrumentCell cellOf(Instrument instrument)
{
    const int number = static_cast<int>(instrument);
    const float side = 1.0F / kColumns;
    const glm::vec2 low =
        side * glm::vec2(static_cast<float>(number % kColumns), static_cast<float>(number / kColumns));
    return {low, low + side};
}

Picture paintInstruments()
{
    Canvas canvas(kSizePx, kSizePx, kFace);
    const float radiusPx = 0.5F * InstrumentCell::kRimShare * kCellPx;
    for (int i = 0; i < static_cast<int>(Instrument::count); ++i)
    {
        const auto instrument = static_cast<Instrument>(i);
        const InstrumentCell cell = cellOf(instrument);
        canvas.setFrame(0.5F * (cell.low + cell.high) * static_cast<float>(kSizePx), glm::vec2(radiusPx));
        if (instrument == Instrument::attitude)
            paintBall(canvas);
        else if (instrument == Instrument::digits)
            paintDrums(canvas);
        else
            paintDial(canvas, dialOf(instrument));
    }
    return canvas.picture();
}

} // namespace scenery::models
