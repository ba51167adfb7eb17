// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <glm/vec2.hpp>

#include "models/Model.h"
#include "models/vehicles/Curve.h"

namespace trainer::models
{

enum class VehicleKind
{
    saloon,
    van,
    bus,
};

/// The shape of a vehicle before seeds stretch it. All curves run over x, the origin in the middle of the vehicle.
/// Units: metres.
struct VehicleForm
{
    double lengthM, widthM, heightM;
    Curve top;    ///< of the middle line
    Curve belt;   ///< where the sides turn inwards: the lower edge of the windows
    Curve half;   ///< half the width
    Curve lean;   ///< by what share of it the roof is narrower
    Curve bottom; ///< of the sides' lower edge
    double railShare; ///< of the way from belt to top, where sides become roof
    double roofPower; ///< how flat the roof is across: 2 an ellipse, more: a box
    double wheelRadiusM, wheelWidthM, archRadiusM;
    glm::dvec2 axles; ///< x of the front and of the rear one
    Painting painting;
};
const VehicleForm& vehicleForm(VehicleKind kind);

/// Where a vehicle's views lie in its picture of kSheetPx by kSheetPx pixels: the side above which the top, above which front and
/// back, all to one scale.
struct VehicleSheet
{
    static constexpr int kSheetPx = 1024;
    static constexpr float kMarginPx = 10.0F;

    explicit VehicleSheet(const VehicleForm& form)
        : length(form.lengthM), width(form.widthM), height(form.heightM),
          pixelsPerM(static_cast<float>(std::min(1000.0 / length, 980.0 / (2.0 * height + width))))
    {
    }

    /// The pixel of (x, z) = (0, 0), (x, y) = (0, 0), (y, z) = (0, 0).
    glm::vec2 sideOriginPx() const { return {512.0F, kMarginPx}; }
    glm::vec2 topOriginPx() const { return {512.0F, 2.0F * kMarginPx + px(height + 0.5 * width)}; }
    glm::vec2 frontOriginPx() const { return {kMarginPx + px(0.5 * width), 3.0F * kMarginPx + px(height + width)}; }
    glm::vec2 backOriginPx() const { return {2.0F * kMarginPx + px(1.5 * width), frontOriginPx().y}; }
    glm::vec2 darkPx() const { return {980.0F, 980.0F}; } ///< the middle of a patch that is nearly black

    float px(double metres) const { return static_cast<float>(metres) * pixelsPerM; }

    double length, width, height;
    float pixelsPerM;
};

} // namespace trainer::models
