// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <glm/vec2.hpp>

#include "scenery/models/vehicles/Curve.h"

namespace scenery::models
{

/// The shape of a vehicle before a seed stretches it. All curves run over x; the origin is in the middle of
/// the vehicle. Units: metres.
struct VehicleForm
{
    double lengthM = 0.0, widthM = 0.0, heightM = 0.0;
    Curve top;              ///< of the middle line
    Curve belt;             ///< where the sides turn inwards: the lower edge of the windows
    Curve half;             ///< half the width
    Curve lean;             ///< share by which the roof is narrower
    Curve bottom;           ///< of the sides' lower edge
    double railShare = 0.8; ///< of the way from belt to top, where sides become roof
    double roofPower = 3.0; ///< how flat the roof is across: 2 an ellipse, more: a box
    double wheelRadiusM = 0.0, wheelWidthM = 0.0, archRadiusM = 0.0;
    glm::dvec2 axles{0.0};    ///< x of the front and of the rear one
    bool hasTwoSides = false; ///< its left differs from the mirror image of its right: doors
};

/// The positions of the views in the texture of kSheetPx by kSheetPx pixels, all to one scale: the right
/// side, above it the top, above that front and back, above those the left side where it differs.
struct VehicleSheet
{
    static constexpr int kSheetPx = 1024;
    static constexpr float kMarginPx = 10.0F;

    explicit VehicleSheet(const VehicleForm& form)
        : length(form.lengthM),
          width(form.widthM),
          height(form.heightM),
          hasTwoSides(form.hasTwoSides),
          pixelsPerM(static_cast<float>(
              std::min(1000.0 / length, 970.0 / ((hasTwoSides ? 3.0 : 2.0) * height + width))))
    {
    }

    /// The pixel at the views' (0, 0).
    glm::vec2 sideOriginPx() const { return {512.0F, kMarginPx}; }
    glm::vec2 leftOriginPx() const
    {
        return hasTwoSides ? glm::vec2(512.0F, 4.0F * kMarginPx + px(2.0 * height + width)) : sideOriginPx();
    }
    glm::vec2 topOriginPx() const { return {512.0F, 2.0F * kMarginPx + px(height + 0.5 * width)}; }
    glm::vec2 frontOriginPx() const
    {
        return {kMarginPx + px(0.5 * width), 3.0F * kMarginPx + px(height + width)};
    }
    glm::vec2 backOriginPx() const { return {2.0F * kMarginPx + px(1.5 * width), frontOriginPx().y}; }
    glm::vec2 darkPx() const
    {
        return {980.0F, frontOriginPx().y + 60.0F};
    } ///< the middle of a patch that is nearly black

    float px(double metres) const { return static_cast<float>(metres) * pixelsPerM; }

    double length, width, height;
    bool hasTwoSides;
    float pixelsPerM;
};

} // namespace scenery::models
