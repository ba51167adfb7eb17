// SPDX-License-Identifier: Apache-2.0
// entity_sheet FOLDER [NAME]: draws pictures of moving entities from near by: each category from its left
// side, its front right and its back left, walks in four phases, lamps in four states, wheels that steer;
// FOLDER/entities.png has them all. Prints counts.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Angle.h>

#include <osgOffscreen/PngFile>

#include "Picture.h"
#include "Plain.h"
#include "measurement/view/ContactSheet.h"
#include "scenery/models/entities/DefaultSize.h"
#include "scenery/nodes/EntityNode.h"

namespace
{

using scenery::models::EntityKind;
using scenery::models::EntityLamp;
using scenery::models::EntityShape;

constexpr double kEyeM = 1.7;

struct Subject
{
    std::string name;
    EntityKind kind;
    simulation::EntityState state{};
    scenery::models::LitLamps lit{};
    double headingDeg = 0.0; ///< of the only camera; 0: three cameras
};

const std::vector<std::pair<std::string, EntityKind>> kKinds = {{"car", EntityKind::car},
                                                                {"van", EntityKind::van},
                                                                {"bus", EntityKind::bus},
                                                                {"lorry", EntityKind::lorry},
                                                                {"tractor", EntityKind::tractor},
                                                                {"semitrailer", EntityKind::semitrailer},
                                                                {"trailer", EntityKind::trailer},
                                                                {"motorbike", EntityKind::motorbike},
                                                                {"bicycle", EntityKind::bicycle},
                                                                {"pedestrian", EntityKind::pedestrian},
                                                                {"wheelchair", EntityKind::wheelchair},
                                                                {"horse", EntityKind::horse},
                                                                {"cow", EntityKind::cow},
                                                                {"sheep", EntityKind::sheep},
                                                                {"deer", EntityKind::deer},
                                                                {"dog", EntityKind::dog},
                                                                {"aircraft", EntityKind::lightAircraft},
                                                                {"glider", EntityKind::glider},
                                                                {"airliner", EntityKind::airliner},
                                                                {"helicopter", EntityKind::helicopter},
                                                                {"ship", EntityKind::ship},
                                                                {"cone", EntityKind::cone},
                                                                {"barrier", EntityKind::barrier},
                                                                {"pole", EntityKind::pole},
                                                                {"box", EntityKind::box}};

scenery::models::LitLamps lampsOf(std::initializer_list<EntityLamp::Kind> kinds)
{
    scenery::models::LitLamps lit{};
    for (const EntityLamp::Kind kind : kinds)
        lit[static_cast<std::size_t>(kind)] = true;
    return lit;
}

EntityShape shapeOf(EntityKind kind)
{
    EntityShape shape;
    shape.kind = kind;
    shape.red = 0.72F;
    shape.green = 0.10F;
    shape.blue = 0.09F;
    if (kind == EntityKind::box) shape.red = 0.58F, shape.green = 0.44F, shape.blue = 0.28F;
    if (scenery::models::isAnimal(kind)) shape.red = 0.33F, shape.green = 0.24F, shape.blue = 0.16F;
    scenery::models::setDefaultSize(shape);
    return shape;
}

std::vector<Subject> subjects()
{
    using Lamp = EntityLamp::Kind;
    std::vector<Subject> all;
    for (const auto& [name, kind] : kKinds)
        all.push_back({name, kind});
    for (const EntityKind kind : {EntityKind::pedestrian, EntityKind::horse})
        for (int phase = 0; phase < 6; ++phase)
        {
            simulation::EntityState state;
            state.speedMps = 1.4;
            state.odometerM = phase * 0.21;
            all.push_back(
                {(kind == EntityKind::horse ? "horse-step" : "pedestrian-step") + std::to_string(phase),
                 kind,
                 state,
                 {},
                 90.0});
        }
    const std::vector<std::pair<std::string, scenery::models::LitLamps>> lamps = {
        {"head", lampsOf({Lamp::head, Lamp::tail})},
        {"brake", lampsOf({Lamp::brake, Lamp::tail})},
        {"left", lampsOf({Lamp::indicatorLeft})}};
    for (const EntityKind kind : {EntityKind::car, EntityKind::van, EntityKind::bus, EntityKind::lorry,
                                  EntityKind::motorbike, EntityKind::semitrailer})
        for (const auto& [name, lit] : lamps)
        {
            simulation::EntityState state;
            state.steeringDeg = 25.0;
            std::string label = kKinds[static_cast<std::size_t>(kind)].first;
            label.append("-").append(name);
            all.push_back({label, kind, state, lit, name == "head" ? 30.0 : 155.0});
        }
    return all;
}

/// What is looked at. Units: metres.
struct Extent
{
    double middleXM, lengthM, heightM;
};

std::vector<View> viewsOf(const Extent& extent, double headingDeg)
{
    const double away = std::max({0.95 * extent.lengthM + 1.0, 1.9 * extent.heightM, 1.5});
    const glm::dvec3 middle(extent.middleXM, 0.0, 0.5 * extent.heightM);
    const double eyeM = extent.lengthM > 20.0 ? extent.heightM : std::min(kEyeM, 1.6 * middle.z + 0.4);
    const auto from = [&](const char* name, double turnDeg) -> View
    {
        const double turn = foundation::radiansOf(turnDeg);
        const glm::dvec3 eye(middle.x + away * std::cos(turn), middle.y + away * std::sin(turn), eyeM);
        return {name, eye, middle, 40.0};
    };
    if (headingDeg != 0.0) return {from("", headingDeg)};
    return {from("-side", 90.0), from("-front", -38.0), from("-back", 155.0)};
}

void drawOne(const std::filesystem::path& stem, osg::Node& node, const Extent& extent, double headingDeg,
             std::vector<std::filesystem::path>& files)
{
    for (const View& view : viewsOf(extent, headingDeg))
    {
        const osg::ref_ptr<osgSky::Atmosphere> air = new osgSky::Atmosphere;
        const auto picture = pictureOf(onPlain(node, *air), view);
        files.emplace_back(stem.string() + view.name + ".png");
        if (const auto written = osgOffscreen::writePng(*picture, files.back()); written) continue;
        std::fprintf(stderr, "%s cannot be written\n", files.back().c_str());
        std::exit(1);
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2)
    {
        std::fprintf(stderr, "usage: entity_sheet FOLDER [NAME]\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const std::string only = argc > 2 ? argv[2] : "";
    std::vector<std::filesystem::path> files;
    for (const Subject& subject : subjects())
    {
        if (!subject.name.starts_with(only)) continue;
        scenery::EntityShapes shapes;
        const EntityShape shape = shapeOf(subject.kind);
        scenery::EntityNode entity(shape, shapes);
        entity.setState(subject.state, subject.lit);
        drawOne(folder / subject.name, *entity.node(), {shape.middleXM, shape.lengthM, shape.heightM},
                subject.headingDeg, files);
    }
    const auto sheet = measurement::makeContactSheet(files, {6, 100, 1944, 4});
    if (!sheet || !osgOffscreen::writePng(**sheet, folder / "entities.png"))
    {
        std::fprintf(stderr, "the sheet could not be written\n");
        return 1;
    }
    return 0;
}
