// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/StandingAircraft.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>

#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/mesh/MeshBuilder.h>

#include "scenery/models/entities/DefaultSize.h"
#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/mesh/MeasureModel.h"

namespace scenery::models
{

namespace
{

namespace core = osgPMObjects::core;

/// Joins models to one.
class Joined
{
public:
    void add(const Model& part, const glm::dmat4& place)
    {
        const core::Mesh& mesh = part.mesh;
        for (const core::Face& face : mesh.faces)
        {
            core::Face copy;
            copy.material = materialOf(mesh.materials[face.material], part);
            copy.part = _mesh.part(mesh.parts[face.part].name);
            for (std::size_t i = 0; i < 3; ++i)
            {
                core::Wedge wedge = core::wedgeOf(mesh, face.wedges[i]);
                wedge.position =
                    _mesh.position(glm::dvec3(place * glm::dvec4(mesh.positions[wedge.position], 1.0)));
                wedge.normal = glm::mat3(place) * wedge.normal;
                copy.wedges[i] = _mesh.wedge(wedge);
            }
            _mesh.face(copy);
        }
    }

    Model finish()
    {
        Model model;
        model.mesh = _mesh.finish();
        model.surfaces = std::move(_surfaces);
        for (const glm::dvec3& p : model.mesh.positions)
        {
            model.radiusM = std::max(model.radiusM, std::hypot(p.x, p.y));
            model.heightM = std::max(model.heightM, p.z);
            model.foundationM = std::max(model.foundationM, -p.z);
        }
        return model;
    }

private:
    std::uint32_t materialOf(core::Material material, const Model& part)
    {
        const Surface& surface = part.surfaces[material.state];
        const auto known = std::find(_surfaces.begin(), _surfaces.end(), surface);
        material.state = static_cast<std::uint32_t>(known - _surfaces.begin());
        if (known == _surfaces.end()) _surfaces.push_back(surface);
        material.name = "surface " + std::to_string(material.state);
        return _mesh.material(material);
    }

    core::MeshBuilder _mesh;
    std::vector<Surface> _surfaces;
};

} // namespace

glm::vec3 aircraftTrim(std::uint64_t seed)
{
    static constexpr std::array kColours{glm::vec3(0.10F, 0.22F, 0.50F), glm::vec3(0.70F, 0.10F, 0.09F),
                                         glm::vec3(0.12F, 0.36F, 0.24F), glm::vec3(0.84F, 0.42F, 0.08F),
                                         glm::vec3(0.14F, 0.15F, 0.18F), glm::vec3(0.80F, 0.62F, 0.12F)};
    return kColours[seed % kColours.size()];
}

Model makeStandingAircraft(EntityKind kind, std::uint64_t seed)
{
    EntityShape shape;
    shape.kind = kind;
    setDefaultSize(shape);
    const glm::vec3 trim = aircraftTrim(seed);
    shape.red = trim.r;
    shape.green = trim.g;
    shape.blue = trim.b;
    const bool hasLowWing = kind == EntityKind::lightAircraft && seed % 2 == 0;
    const EntityModel moving = hasLowWing ? makeLowWingAircraft(shape) : makeEntityModel(shape);
    const std::vector<glm::dmat4> pose = moving.pose({});
    Joined joined;
    for (std::size_t part = 0; part < moving.parts.size(); ++part)
    {
        glm::dmat4 place = pose[part];
        place[3].x -= shape.middleXM; // the origin lies below the middle
        joined.add(moving.meshes[moving.parts[part]], place);
    }
    return joined.finish();
}

} // namespace scenery::models
