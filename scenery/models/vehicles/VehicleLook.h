// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <foundation/ContentMark.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scenery/models/vehicles/VehicleForm.h"

/// What a car, van or bus looks like, as its file says (docs/reference/vehicle-look-file.md).
/// Frame: x forward, y left, z up, the origin on the ground below the middle. Units: metres; colours as
/// display values.
namespace scenery::models
{

/// As what it counts, for its interior and for what sizes it may have.
enum class VehicleKind
{
    car,
    van,
    bus,
};

/// The shares between which seeds stretch a vehicle along an axis.
struct StretchRange
{
    double least = 1.0, most = 1.0;
};

/// Limits that hold for every seed.
struct LookBounds
{
    double leastHeightM = 0.0, mostHeightM = 0.0;
    double mostRadiusM = 0.0; ///< of the circle around the middle
};

/// A lamp on both sides.
struct LookLamp
{
    glm::dvec2 at{0.0}; ///< y and z of its middle
    glm::dvec2 sizeM{0.0};
};

/// A mirror on the left; the right one is its mirror image.
struct LookMirror
{
    glm::dvec3 foot{0.0}, head{0.0}; ///< ends of its arm
    double radiusM = 0.0, lengthM = 0.0;
    bool isWide = false; ///< its length lies across, else upright
};

/// Where the driver's eye is: shares of the size, and what is added to them.
struct LookEye
{
    double alongShare = 0.0, alongM = 0.0; ///< from the back
    double leftShare = 0.0;                ///< of the width, from the middle
    double upShare = 0.0, upM = 0.0;
};

/// Something painted on a view. Its points are the view's: x or y to the right, z or y up.
struct LookMark
{
    enum class Kind
    {
        glass,
        fill,
        box,
        seam,
        plate,
    };
    Kind kind = Kind::glass;
    std::vector<glm::vec2> points; ///< corners; two of a box: lowest, highest; one of a plate: its middle
    glm::vec4 colour{0.0F};        ///< of a fill or box; alpha: share of the vehicle's colour
    float cornerM = 0.0F;          ///< radius of a box's corners
    bool isOnBothSides = false;    ///< also mirrored about the middle line
    int repeats = 1;
    glm::vec2 step{0.0F}; ///< from one repeat to the next
};

/// The views that are painted.
enum class LookView
{
    sides, ///< both
    right,
    left,
    top,
    front,
    back,
    count,
};

struct VehicleLook
{
    std::string name;
    VehicleKind kind = VehicleKind::car;
    VehicleForm form;
    LookBounds bounds;
    std::uint64_t seed = 60000; ///< added to seeds, so that kinds differ by the same one
    StretchRange length{0.96, 1.05}, width{0.98, 1.02}, height{0.97, 1.05};
    std::vector<glm::vec3> colours; ///< of which seeds and names choose; not empty
    LookLamp headLamps, tailLamps;
    LookMirror mirrors;
    LookEye eye;
    std::array<std::vector<LookMark>, static_cast<std::size_t>(LookView::count)> paint;
    foundation::ContentMark mark{}; ///< of its text

    const std::vector<LookMark>& marksOf(LookView view) const
    {
        return paint[static_cast<std::size_t>(view)];
    }
};

} // namespace scenery::models
