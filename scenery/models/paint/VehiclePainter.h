// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "scenery/models/paint/Canvas.h"
#include "scenery/models/vehicles/VehicleForm.h"

namespace scenery::models
{

/// Paints the texture of a vehicle view by view, in metres. Unpainted pixels are bodywork: white, to be
/// tinted.
class VehiclePainter
{
public:
    enum class View
    {
        side,  ///< the right one, or both: x to the right, z up
        left,  ///< the same, where it is another
        top,   ///< x to the right, y up
        front, ///< y to the right, z up
        back,  ///< y to the right, z up
    };
    using Outline = std::vector<glm::vec2>;

    explicit VehiclePainter(const VehicleForm& form);

    void look(View view);
    /// Paints glass with a black seal around it, lighter towards its upper edge.
    void glass(const Outline& outline);
    void fill(const Outline& outline, const glm::vec4& colour) { _canvas.polygon(outline, colour); }
    void box(const glm::vec2& low, const glm::vec2& high, float radius, const glm::vec4& colour);
    /// Paints a gap between panels, a centimetre wide.
    void seam(const Outline& line);
    void plate(const glm::vec2& middle);

    Picture picture() const { return _canvas.picture(); }

    // Alpha 0: no tint.
    static constexpr glm::vec4 kGlass{0.09F, 0.11F, 0.13F, 0.0F};
    static constexpr glm::vec4 kSkyInGlass{0.22F, 0.27F, 0.31F, 0.0F};
    static constexpr glm::vec4 kBlack{0.10F, 0.10F, 0.11F, 0.0F};
    static constexpr glm::vec4 kPlastic{0.20F, 0.20F, 0.21F, 0.0F};
    static constexpr glm::vec4 kLamp{0.90F, 0.91F, 0.92F, 0.0F};
    static constexpr glm::vec4 kTailLamp{0.55F, 0.03F, 0.04F, 0.0F};
    static constexpr glm::vec4 kAmber{0.85F, 0.45F, 0.08F, 0.0F};
    static constexpr glm::vec4 kChrome{0.70F, 0.71F, 0.73F, 0.0F};
    static constexpr glm::vec4 kShade{0.62F, 0.62F, 0.62F, 1.0F}; ///< bodywork in a groove

private:
    VehicleSheet _sheet;
    Canvas _canvas;
};

} // namespace scenery::models
