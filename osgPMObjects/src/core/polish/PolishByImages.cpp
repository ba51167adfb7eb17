// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <osgPMObjects/core/polish/PolishByImages.h>
#include <osgPMObjects/core/simplify/JoinSequences.h>

#include "../simplify/sequence/LevelErrors.h"
#include "ImageCollapser.h"
#include "PlaceMover.h"
#include "PolishState.h"

namespace osgPMObjects::core
{

namespace
{

/// Converts steps of a state to units of the mesh, with errors that never decrease.
CollapseSequence inUnitsOf(CollapseSequence steps, const ImageFrame& frame)
{
    LevelError error;
    for (CollapseStep& step : steps.steps)
    {
        step.error = error = raisedBy(step.error, frame.diagonal, error);
    }
    for (glm::dvec3& place : steps.places)
        place = frame.out(place);
    return steps;
}

} // namespace

CollapseSequence polishByImages(const Mesh& mesh, const CollapseSequence& sequence, std::size_t targetFaces,
                                std::span<const MaterialLook> looks, const PolishSettings& settings)
{
    const auto startFaces =
        static_cast<std::size_t>(std::ceil(static_cast<double>(targetFaces) * settings.start));
    CollapseSequence polished = firstSteps(sequence, stepsToFaces(sequence, startFaces));
    const bool movesPlaces = settings.simplify.placement != Placement::subset;
    PolishState state(mesh, meshAfter(mesh, polished, polished.steps.size()), looks, settings);
    CollapseSequence chosen = ImageCollapser(state, settings, movesPlaces).run(targetFaces);
    if (movesPlaces) PlaceMover(state).run(chosen, settings.moveRounds);
    polished = joined(mesh, std::move(polished), inUnitsOf(std::move(chosen), ImageFrame(mesh.positions)));
    const Mesh level = meshAfter(mesh, polished, polished.steps.size());
    SimplifySettings below = settings.simplify;
    below.envelope = 0.0; // it would be around this level, not the original
    return joined(mesh, std::move(polished), simplify(level, below));
}

} // namespace osgPMObjects::core
