// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgTraversal/AllowedError>
#include <osgTraversal/CullFacts>

namespace osgTraversal
{

AllowedError allowedErrorOf(osgUtil::CullVisitor& visitor, const viewlod::ViewState& view, double tolerancePx,
                            double nearest)
{
    const double pixels = tolerancePx * lodScaleOf(visitor);
    if (isParallel(toGlm(*visitor.getProjectionMatrix())))
        return {pixels / view.pixelsPerTangent / kEverywhere, kEverywhere};
    if (!seeksNearFar(visitor)) nearest = view.nearM / eyePerLocal(*visitor.getModelViewMatrix());
    return {pixels / view.guaranteedPixelsPerTangent(), std::max(nearest, 1e-3)};
}

} // namespace osgTraversal
