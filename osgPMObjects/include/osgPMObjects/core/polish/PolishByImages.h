// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/simplify/Simplify.h>

namespace osgPMObjects::core
{

/// How light a material is, all that pictures for polishing know of its state.
struct MaterialLook
{
    float luminance = 1.0f; ///< 0…1, times the wedges' colours where the material has them
    /// Luminance of the texture of set 0, rows from v = 0 up, repeated; empty: none.
    std::vector<std::uint8_t> texels;
    std::uint32_t texelsWide = 0, texelsHigh = 0;
};

/// How a level is polished, and how much is spent on it.
struct PolishSettings
{
    SimplifySettings simplify{}; ///< what the sequence was made with
    int views = 32;              ///< directions all around; 0: quadrics alone
    int sizePx = 128;            ///< width and height of each picture, which the model fills
    double start = 3.0;          ///< how many times the wanted faces there are when pictures take over
    int choices = 4;    ///< of each position those collapses are drawn that cost least by their quadrics
    int moveRounds = 8; ///< rounds of moving positions, unless their placement is subset
    double shapeShare =
        1.0; ///< what the surface's distance counts beside the pictures: it keeps the shape of what cannot be seen
    float background = 0.45f; ///< luminance behind the model
};

/// Makes of a sequence one whose level of `targetFaces` faces looks more like the mesh: its last steps before that level are chosen
/// anew by what they change in pictures of the original from all around, shaded by a lamp at the eye. Levels before are as they
/// were; those after are made by quadrics again. Unless placement is subset, positions of that level are then moved to where the pictures are
/// best. Symmetric models may become lopsided, and an envelope
/// is not kept from where pictures take over. The last face of a material goes when nothing else is left.
/// `looks`: by material; where there are fewer, the rest is white. The sequence has to be one of the mesh (isSequenceOf()).
/// Deterministic: the same for any number of threads. Memory: 48 B a pixel and view, 16 B a pixel of each face in each view.
/// Cost: docs/algorithms/image-driven.md; it grows with the steps chosen anew and their pixels; of the mesh all faces are drawn once.
/// Source: Lindstrom and Turk, "Image-driven simplification" (2000): the cost, and that only changed triangles are drawn anew. Ours
/// keeps all layers of each pixel, so that what a face hid is known without drawing; pictures take over from quadrics near the
/// end only, look at those collapses only that quadrics want, and also move positions.
CollapseSequence polishByImages(const Mesh& mesh, const CollapseSequence& sequence, std::size_t targetFaces,
                                std::span<const MaterialLook> looks, const PolishSettings& settings = {});

} // namespace osgPMObjects::core
