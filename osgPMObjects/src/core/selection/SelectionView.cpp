// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

SelectionView SelectionView::from(const viewlod::ViewState& view, double magnification,
                                  double referencePixelsPerTangent)
{
    assert(magnification > 0.0 && referencePixelsPerTangent >= 0.0);
    const glm::dmat4 rows = glm::transpose(view.clipFromWorld);
    const double unit = glm::length(glm::dvec3(rows[3]));
    assert(unit > 0.0 && "a parallel projection has no distances to choose by");
    SelectionView selection;
    selection.eyeWorld = view.eyeWorld;
    selection.acrossPx = glm::dvec3(rows[0]) * (0.5 * magnification * view.widthPx / unit);
    selection.upPx = glm::dvec3(rows[1]) * (0.5 * magnification * view.heightPx / unit);
    selection.forward = glm::dvec3(rows[3]) / unit;
    selection.pixelsPerTangent = view.pixelsPerTangent * magnification;
    selection.guaranteedPixelsPerTangent = view.guaranteedPixelsPerTangent() * magnification;
    selection.pixelsPerTangentArea =
        std::abs(glm::dot(glm::cross(selection.acrossPx, selection.upPx), selection.forward));
    const double reference =
        referencePixelsPerTangent > 0.0 ? referencePixelsPerTangent : view.pixelsPerTangent;
    selection.distanceScale = reference / selection.pixelsPerTangent;
    selection.nearM = view.nearM;
    return selection;
}

} // namespace osgPMObjects::core
