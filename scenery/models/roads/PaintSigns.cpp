// SPDX-License-Identifier: Apache-2.0
// Source: Convention on Road Signs and Signals (Vienna, 1968), annex 1; how the countries differ is left out.
#include "scenery/models/roads/PaintSigns.h"

#include <string>

#include "scenery/models/roads/SignCells.h"
#include "scenery/models/roads/SignPainter.h"

namespace scenery::models
{

namespace
{

using Painter = SignPainter;

void paintRule(Painter& to, SignFace face)
{
    switch (face)
    {
    case SignFace::plain:
        return to.ground({1.0F, 1.0F, 1.0F, 1.0F});
    case SignFace::back:
        return to.ground(Painter::kGrey);
    case SignFace::stop:
        to.ground(Painter::kWhite);
        to.fill({{-0.92F, -0.38F},
                 {-0.38F, -0.92F},
                 {0.38F, -0.92F},
                 {0.92F, -0.38F},
                 {0.92F, 0.38F},
                 {0.38F, 0.92F},
                 {-0.38F, 0.92F},
                 {-0.92F, 0.38F}},
                Painter::kRed);
        return to.text("STOP", 0.48F, Painter::kWhite);
    case SignFace::giveWay:
        return to.triangle(false);
    case SignFace::priority:
    case SignFace::priorityEnd:
        to.ground(Painter::kWhite);
        to.fill({{-0.66F, 0.0F}, {0.0F, -0.66F}, {0.66F, 0.0F}, {0.0F, 0.66F}}, Painter::kYellow);
        if (face == SignFace::priorityEnd)
            for (const float x : {-0.15F, 0.0F, 0.15F})
                to.line({{x - 0.42F, -0.42F}, {x + 0.42F, 0.42F}}, 0.06F, Painter::kBlack);
        return;
    case SignFace::noEntry:
        to.ground(Painter::kRed);
        return to.fill({{-0.72F, -0.16F}, {0.72F, -0.16F}, {0.72F, 0.16F}, {-0.72F, 0.16F}}, Painter::kWhite);
    case SignFace::noOvertaking:
        to.ring(Painter::kRed, Painter::kWhite);
        to.car({-0.3F, 0.0F}, 0.46F, Painter::kRed);
        return to.car({0.3F, 0.0F}, 0.46F, Painter::kBlack);
    case SignFace::overtakingEnd:
        to.ring(Painter::kGrey, Painter::kWhite);
        to.car({-0.3F, 0.0F}, 0.46F, Painter::kGrey);
        to.car({0.3F, 0.0F}, 0.46F, Painter::kGrey);
        return to.line({{-0.5F, -0.5F}, {0.5F, 0.5F}}, 0.12F, Painter::kBlack);
    case SignFace::allEnd:
        to.ring(Painter::kGrey, Painter::kWhite);
        for (const float x : {-0.2F, 0.0F, 0.2F})
            to.line({{x - 0.45F, -0.45F}, {x + 0.45F, 0.45F}}, 0.07F, Painter::kBlack);
        return;
    default:
        return to.ring(Painter::kRed, Painter::kWhite); // noVehicles, limit
    }
}

void paintGuide(Painter& to, SignFace face)
{
    to.ground(Painter::kBlue);
    switch (face)
    {
    case SignFace::ahead:
        return to.arrow({0.0F, -0.7F}, {0.0F, 0.7F}, Painter::kWhite);
    case SignFace::right:
        return to.arrow({-0.7F, 0.0F}, {0.7F, 0.0F}, Painter::kWhite);
    case SignFace::left:
        return to.arrow({0.7F, 0.0F}, {-0.7F, 0.0F}, Painter::kWhite);
    case SignFace::keepRight:
        return to.arrow({-0.45F, 0.45F}, {0.5F, -0.5F}, Painter::kWhite);
    case SignFace::roundabout:
        to.arrow({-0.6F, -0.25F}, {0.0F, 0.62F}, Painter::kWhite);
        to.arrow({0.2F, 0.6F}, {0.5F, -0.35F}, Painter::kWhite);
        return to.arrow({0.45F, -0.5F}, {-0.55F, -0.45F}, Painter::kWhite);
    case SignFace::crossing:
        to.fill({{-0.78F, -0.66F}, {0.78F, -0.66F}, {0.0F, 0.78F}}, Painter::kWhite);
        for (const float x : {-0.42F, -0.14F, 0.14F, 0.42F})
            to.fill({{x - 0.08F, -0.62F},
                     {x + 0.08F, -0.62F},
                     {x * 0.8F + 0.06F, -0.42F},
                     {x * 0.8F - 0.06F, -0.42F}},
                    Painter::kBlack);
        return to.person({0.0F, -0.46F}, 0.85F, Painter::kBlack);
    case SignFace::parking:
        return to.text("P", 1.3F, Painter::kWhite);
    case SignFace::motorway:
        to.fill({{-0.62F, -0.8F}, {-0.1F, -0.8F}, {-0.06F, 0.8F}, {-0.2F, 0.8F}}, Painter::kWhite);
        to.fill({{0.1F, -0.8F}, {0.62F, -0.8F}, {0.2F, 0.8F}, {0.06F, 0.8F}}, Painter::kWhite);
        return to.fill({{-0.8F, 0.2F}, {0.8F, 0.2F}, {0.8F, 0.34F}, {-0.8F, 0.34F}}, Painter::kWhite);
    default:
        return;
    }
}

void paintWarning(Painter& to, SignFace face)
{
    to.triangle(true);
    const glm::vec4& ink = Painter::kBlack;
    switch (face)
    {
    case SignFace::bendRight:
        return to.line({{-0.12F, -0.65F}, {-0.12F, -0.2F}, {0.12F, -0.02F}, {0.12F, 0.15F}}, 0.13F, ink);
    case SignFace::bendLeft:
        return to.line({{0.12F, -0.65F}, {0.12F, -0.2F}, {-0.12F, -0.02F}, {-0.12F, 0.15F}}, 0.13F, ink);
    case SignFace::roadWorks:
        to.person({-0.12F, -0.7F}, 0.85F, ink);
        to.line({{0.05F, -0.2F}, {0.36F, -0.6F}}, 0.07F, ink);
        return to.fill({{0.1F, -0.72F}, {0.56F, -0.72F}, {0.34F, -0.46F}}, ink);
    case SignFace::slippery:
        to.car({0.0F, -0.1F}, 0.4F, ink);
        to.line({{-0.14F, -0.68F}, {-0.24F, -0.5F}, {-0.1F, -0.36F}}, 0.06F, ink);
        return to.line({{0.2F, -0.68F}, {0.1F, -0.5F}, {0.24F, -0.36F}}, 0.06F, ink);
    case SignFace::pedestrians:
        return to.person({0.0F, -0.7F}, 0.95F, ink);
    case SignFace::lights:
        to.disc({0.0F, 0.1F}, 0.14F, Painter::kRed);
        to.disc({0.0F, -0.25F}, 0.14F, Painter::kYellow);
        return to.disc({0.0F, -0.6F}, 0.14F, {0.05F, 0.55F, 0.25F, 0.0F});
    case SignFace::narrow:
        to.line({{-0.3F, -0.65F}, {-0.3F, -0.4F}, {-0.12F, -0.2F}, {-0.12F, 0.1F}}, 0.11F, ink);
        return to.line({{0.3F, -0.65F}, {0.3F, -0.4F}, {0.12F, -0.2F}, {0.12F, 0.1F}}, 0.11F, ink);
    case SignFace::crossroads:
        to.line({{-0.3F, -0.6F}, {0.3F, 0.0F}}, 0.14F, ink);
        return to.line({{0.3F, -0.6F}, {-0.3F, 0.0F}}, 0.14F, ink);
    default:
        to.fill({{-0.09F, 0.25F}, {0.09F, 0.25F}, {0.06F, -0.35F}, {-0.06F, -0.35F}}, ink);
        return to.disc({0.0F, -0.56F}, 0.1F, ink);
    }
}

void paintCell(Painter& to, int index)
{
    const auto face = static_cast<SignFace>(index);
    if (index >= kFirstRunwayGlyph)
    {
        to.ground(Painter::kRed);
        return to.text(kRunwayGlyphs.substr(static_cast<std::size_t>(index - kFirstRunwayGlyph), 1), 1.3F,
                       Painter::kWhite);
    }
    if (index >= kFirstGlyph)
    {
        to.ground({1.0F, 1.0F, 1.0F, 1.0F});
        return to.text(kGlyphs.substr(static_cast<std::size_t>(index - kFirstGlyph), 1), 1.3F,
                       Painter::kBlack);
    }
    if (index >= kFirstLeast)
    {
        to.ground(Painter::kBlue);
        return to.text(std::to_string(10 * (index - kFirstLeast + 3)), 0.8F, Painter::kWhite);
    }
    if (index >= kFirstLimit)
    {
        paintRule(to, SignFace::limit);
        const std::string number = std::to_string(5 * (index - kFirstLimit + 1));
        return to.text(number, number.size() > 2 ? 0.52F : 0.74F, Painter::kBlack);
    }
    if (face >= SignFace::lampRed)
        return to.ground(face == SignFace::lampRed     ? glm::vec4(0.16F, 0.03F, 0.03F, 0.0F)
                         : face == SignFace::lampAmber ? glm::vec4(0.16F, 0.11F, 0.02F, 0.0F)
                                                       : glm::vec4(0.02F, 0.13F, 0.08F, 0.0F));
    if (face == SignFace::least) return to.ground(Painter::kBlue);
    if (face >= SignFace::danger && face <= SignFace::crossroads) return paintWarning(to, face);
    if (face >= SignFace::ahead && face <= SignFace::motorway) return paintGuide(to, face);
    paintRule(to, face);
}

} // namespace

Picture paintSigns()
{
    Canvas canvas(kSignColumns * kSignCellPx, kSignRows * kSignCellPx, {1.0F, 1.0F, 1.0F, 1.0F});
    constexpr float kHalf = 0.5F * kSignCellPx;
    for (int index = 0; index < kSignColumns * kSignRows; ++index)
    {
        const glm::ivec2 cell(index % kSignColumns, index / kSignColumns);
        canvas.setFrame((glm::vec2(cell) + 0.5F) * static_cast<float>(kSignCellPx), glm::vec2(kHalf));
        SignPainter painter(canvas);
        paintCell(painter, index);
    }
    return canvas.picture();
}

} // namespace scenery::models
