// SPDX-License-Identifier: Apache-2.0
// model_sheet FOLDER [KIND [SEED [DISTANCE]]]: draws pictures of generated models, three of each kind (or of
// one): from its front right and its back left at eye level, and from 150 m away, 45 m up, through a longer
// lens; FOLDER/models.png has them all. Prints sizes and counts.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Angle.h>

#include <osgOffscreen/PngFile>

#include "Picture.h"
#include "Plain.h"
#include "measurement/view/ContactSheet.h"
#include "scenery/models/Catalogue.h"
#include "scenery/nodes/ModelStates.h"

namespace
{

using scenery::models::KindFacts;

constexpr double kEyeM = 1.7;

/// Returns the three views of a model. `distanceM`: of the two near views; 0: far enough to see the whole
/// model.
std::vector<View> viewsOf(const scenery::models::Model& model, double distanceM)
{
    const double whole = std::max(2.5 * model.radiusM, 1.55 * model.heightM + 0.5 * model.radiusM);
    const double away = distanceM > 0.0 ? distanceM : whole;
    const glm::dvec3 target(0.0, 0.0, distanceM > 0.0 ? kEyeM : 0.47 * model.heightM);
    const auto from = [&](double headingDeg, double levelM, double upM)
    {
        const double turn = foundation::radiansOf(headingDeg);
        return glm::dvec3(levelM * std::cos(turn), levelM * std::sin(turn), upM);
    };
    return {{"front", from(-38.0, away, kEyeM), target, 40.0},
            {"back", from(145.0, away, kEyeM), target, 40.0},
            {"far", from(-60.0, 143.0, 45.0), target, 14.0}};
}

void report(const KindFacts& facts, const scenery::models::Model& model, double ms)
{
    std::printf("%-13s %6zu triangles %6zu wedges %zu surfaces  radius %5.2f m  height %5.2f m  %.1f ms\n",
                std::string(facts.name).c_str(), model.mesh.faces.size(), model.mesh.wedgeCount(),
                model.surfaces.size(), model.radiusM, model.heightM, ms);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2)
    {
        std::fprintf(stderr, "usage: model_sheet FOLDER [KIND [SEED [DISTANCE]]]\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
    const double distanceM = argc > 4 ? std::strtod(argv[4], nullptr) : 0.0;
    std::vector<std::filesystem::path> files;
    for (const KindFacts& facts : scenery::models::kinds())
    {
        if (argc > 2 && facts.name != argv[2]) continue;
        const auto before = std::chrono::steady_clock::now();
        const scenery::models::Model model = scenery::models::generate(facts.kind, seed);
        report(facts, model,
               std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count());
        for (const View& view : viewsOf(model, distanceM))
        {
            // Each picture has a context of its own, so textures and programs are made anew.
            scenery::ModelStates states;
            const osg::ref_ptr<osgSky::Atmosphere> air = new osgSky::Atmosphere;
            const auto picture = pictureOf(onPlain(*scenery::makeModelNode(model, states), *air), view);
            files.push_back(folder / (std::string(facts.name) + "-" + view.name + ".png"));
            if (const auto written = osgOffscreen::writePng(*picture, files.back()); !written)
            {
                std::fprintf(stderr, "%s\n", written.error().message().c_str());
                return 1;
            }
        }
    }
    const auto sheet = measurement::makeContactSheet(files, {6, 100, 1944, 4});
    if (!sheet || !osgOffscreen::writePng(**sheet, folder / "models.png"))
    {
        std::fprintf(stderr, "the sheet could not be written\n");
        return 1;
    }
    return 0;
}
