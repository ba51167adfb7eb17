// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include <viewlod/Frustum.h>

namespace viewlod
{

/// The view of one camera in one frame, as level-of-detail selection needs it.
/// Frame: world (local east-north-up), or the frame of the caller's matrices.
/// Units: metres, pixels.
struct ViewState
{
    glm::dvec3 eyeWorld{0.0};
    glm::dmat4 clipFromWorld{1.0}; ///< projection × view; the tests project with it
    Frustum frustum;
    double pixelsPerTangent = 0.0; ///< K: pixels per unit of tangent at the image centre (ScreenError.h)
    double cornerStretch =
        1.0; ///< 1/cos² of the angle to the farthest corner: the factor by which pixels grow there
    double nearM = 1.0; ///< distance under which nothing is guaranteed
    int widthPx = 0;
    int heightPx = 0;

    /// Makes a view from OpenGL view and perspective (possibly off-axis) projection matrices and the viewport
    /// in pixels.
    static ViewState fromMatrices(const glm::dmat4& view, const glm::dmat4& projection, int widthPx,
                                  int heightPx)
    {
        ViewState state;
        state.eyeWorld = glm::dvec3(glm::inverse(view)[3]);
        state.clipFromWorld = projection * view;
        state.frustum = Frustum(state.clipFromWorld);
        state.widthPx = widthPx;
        state.heightPx = heightPx;
        state.pixelsPerTangent =
            std::max(0.5 * widthPx * projection[0][0], 0.5 * heightPx * projection[1][1]);
        // The edges of an off-axis frustum in tangents: (±1 + offset) / scale.
        const double tangentX = (1.0 + std::abs(projection[2][0])) / projection[0][0];
        const double tangentY = (1.0 + std::abs(projection[2][1])) / projection[1][1];
        state.cornerStretch = 1.0 + tangentX * tangentX + tangentY * tangentY;
        state.nearM = projection[3][2] / (projection[2][2] - 1.0);
        return state;
    }

    /// Pixels per unit of tangent that hold everywhere in the image, not only at its centre.
    double guaranteedPixelsPerTangent() const { return pixelsPerTangent * cornerStretch; }
};

} // namespace viewlod
