// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/simplify/Simplify.h>

namespace osgPMObjects::core
{

/// The brightness of a material: what images for polishing show of its state.
struct MaterialLook
{
    float luminance = 1.0f; ///< 0…1, multiplied by the wedges' colours where the material has them
    /// Luminance of the texture in set 0, rows from v = 0 up, repeated; empty: no texture.
    std::vector<std::uint8_t> texels;
    std::uint32_t texelsWide = 0, texelsHigh = 0;
};

/// Settings of polishByImages().
struct PolishSettings
{
    SimplifySettings simplify{}; ///< the settings of the sequence
    int views = 32;              ///< view directions all around; 0: quadrics alone
    int sizePx = 128;            ///< width and height of each image; the model fills it
    double start = 3.0;          ///< images take over at this multiple of the target faces
    int choices = 4;             ///< candidates by image for each position: those of the least quadric cost
    int moveRounds = 8;          ///< rounds of moving positions, unless placement is subset
    /// weight of the distance of surfaces beside image differences; it keeps the shape of hidden surfaces
    double shapeShare = 1.0;
    float background = 0.45f; ///< luminance of the background
};

/// Improves the level of `targetFaces` faces of a sequence. The last steps before that level are chosen
/// again, by how they change images of the original from all around, lit by a lamp at the camera. Earlier
/// levels are kept; later ones are made by quadrics again. Unless placement is subset, positions of that
/// level are then moved to where images match best. Symmetry and an envelope are not kept from the first step
/// chosen by images. The last face of a material is removed only when no other is left.
/// `looks`: by material; missing ones are white. The sequence must be one of the mesh (isSequenceOf()).
/// Deterministic: the same for any number of threads. Memory: 48 B a pixel and view, 16 B a pixel of each
/// face in each view.
/// Cost: docs/measurements/image-driven.md; it grows with the number of chosen steps and their pixels, plus
/// drawing the mesh once.
/// Source: Lindstrom and Turk, *Image-driven simplification* (2000): the cost, and drawing changed triangles
/// only. Differs: we store all layers of each pixel, so that removing a face needs no drawing; images take
/// over from quadrics near the end only, compare only the candidates of least quadric cost, and also move
/// positions.
CollapseSequence polishByImages(const Mesh& mesh, const CollapseSequence& sequence, std::size_t targetFaces,
                                std::span<const MaterialLook> looks, const PolishSettings& settings = {});

} // namespace osgPMObjects::core
