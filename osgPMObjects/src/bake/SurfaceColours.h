// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include <osg/Matrixd>
#include <osg/StateSet>

#include <osgPMObjects/ImportNode>

#include "Finish.h"
#include "TexturePicture.h"

namespace osgPMObjects
{

/// The colours of a model's surfaces without light: textures, materials and vertex colours.
/// Threads: any number at once, after construction.
class SurfaceColours
{
public:
    explicit SurfaceColours(const ImportedModel& full);

    /// Returns the colour of a point of a face, for a map on a face of another material: this colour times
    /// that material's ambient, diffuse and emitted light is what the full model shows. It is exact if the
    /// two materials are the same, and otherwise for diffuse light.
    glm::vec4 at(std::uint32_t face, const glm::dvec3& weights, std::uint32_t shownWith) const;

    const Finish& finish(std::uint32_t material) const { return _finishes[material]; }
    std::size_t texturesNotRead() const { return _texturesNotRead; }

private:
    static constexpr std::size_t kUnits = core::Mesh::kTexCoordSets;

    void addMaterial(const core::Material& material, const osg::StateSet& state,
                     const VertexColours& colours);

    const ImportedModel& _full;
    std::vector<Finish> _finishes;                                    ///< by material
    std::vector<std::array<const TexturePicture*, kUnits>> _pictures; ///< by material and unit; null: none
    std::map<const osg::Texture*, std::unique_ptr<TexturePicture>> _read;
    std::vector<std::array<osg::Matrixd, kUnits>> _texMats;
    std::size_t _texturesNotRead = 0;
};

} // namespace osgPMObjects
