// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

namespace
{

/// Converts the pixels per metre of a parallel projection to pixels per tangent of an eye that is far away.
SelectionView fromFarAway(const viewlod::ViewState& view, const glm::dmat4& rows, double magnification,
                          double referencePixelsPerTangent)
{
    constexpr double kFar = SelectionView::kFarM;
    SelectionView selection;
    selection.forward = glm::normalize(glm::dvec3(rows[2]));
    selection.eyeWorld = view.eyeWorld - kFar * selection.forward;
    selection.acrossPx = glm::dvec3(rows[0]) * (0.5 * magnification * view.widthPx * kFar);
    selection.upPx = glm::dvec3(rows[1]) * (0.5 * magnification * view.heightPx * kFar);
    selection.pixelsPerTangent = view.pixelsPerTangent * magnification * kFar;
    selection.guaranteedPixelsPerTangent = selection.pixelsPerTangent;
    const bool hasReference = referencePixelsPerTangent > 0.0;
    selection.distancesFrom = hasReference ? selection.eyeWorld : view.eyeWorld;
    selection.distanceScale =
        hasReference ? referencePixelsPerTangent / selection.pixelsPerTangent : 1.0 / magnification;
    selection.nearM = 0.0;
    return selection;
}

SelectionView fromEye(const viewlod::ViewState& view, const glm::dmat4& rows, double magnification,
                      double referencePixelsPerTangent)
{
    const double unit = glm::length(glm::dvec3(rows[3]));
    SelectionView selection;
    selection.eyeWorld = view.eyeWorld;
    selection.distancesFrom = view.eyeWorld;
    selection.acrossPx = glm::dvec3(rows[0]) * (0.5 * magnification * view.widthPx / unit);
    selection.upPx = glm::dvec3(rows[1]) * (0.5 * magnification * view.heightPx / unit);
    selection.forward = glm::dvec3(rows[3]) / unit;
    selection.pixelsPerTangent = view.pixelsPerTangent * magnification;
    selection.guaranteedPixelsPerTangent = view.guaranteedPixelsPerTangent() * magnification;
    const double reference =
        referencePixelsPerTangent > 0.0 ? referencePixelsPerTangent : view.pixelsPerTangent;
    selection.distanceScale = reference / selection.pixelsPerTangent;
    selection.nearM = view.nearM;
    return selection;
}

} // namespace

SelectionView SelectionView::from(const viewlod::ViewState& view, double magnification,
                                  double referencePixelsPerTangent)
{
    assert(magnification > 0.0 && referencePixelsPerTangent >= 0.0);
    const glm::dmat4 rows = glm::transpose(view.clipFromWorld);
    const bool isParallel = glm::dvec3(rows[3]) == glm::dvec3(0.0);
    SelectionView selection =
        (isParallel ? fromFarAway : fromEye)(view, rows, magnification, referencePixelsPerTangent);
    selection.pixelsPerTangentArea =
        std::abs(glm::dot(glm::cross(selection.acrossPx, selection.upPx), selection.forward));
    return selection;
}

} // namespace osgPMObjects::core
