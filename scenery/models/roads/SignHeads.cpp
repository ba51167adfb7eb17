// SPDX-License-Identifier: Apache-2.0
// What a post carries: signs, boards and traffic lights, pitched and rolled as a file has them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "scenery/models/roads/Plate.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

using RoadModelKind = RoadModel::Kind;

constexpr glm::vec3 kHousing(0.09F, 0.10F, 0.10F);
constexpr double kLensStepM = 0.28; ///< from lens to lens
constexpr double kHeadDepthM = 0.22, kLightPostM = 0.06;
constexpr double kLensX = -kHeadDepthM - kLightPostM; ///< the front of the head; its back touches the post

/// The radius of the post and the arm behind a plate.
double postRadiusOf(const RoadModel& model)
{
    return model.armM == 0.0 ? kPostRadiusM : 2.0 * kPostRadiusM;
}

/// Adds the post at x = 0, beside the road with an arm where the model has one.
void post(ModelBuilder& builder, const RoadModel& model, double topM, double thick)
{
    if (model.postDepthM <= 0.0) return;
    const double aside = -model.armM;
    builder.begin("post", kPlain, kZinc);
    bar(builder, {0.0, aside, -model.postDepthM}, {0.0, aside, topM}, thick);
    if (model.armM == 0.0) return;
    builder.begin("arm", kPlain, kZinc);
    bar(builder, {0.0, aside, topM - 0.2}, {0.0, 0.0, topM - 0.1}, 0.8 * thick);
}

double headHeightOf(const RoadModel& model)
{
    if (const auto lenses = lensesOf(model).size(); lenses > 0)
        return kLensStepM * static_cast<double>(lenses);
    const double defaultM = model.kind == RoadModelKind::sign ? orElse(model.widthM, 0.6) : 0.6;
    return orElse(model.heightM, defaultM);
}

/// The lines of a board.
std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines(1);
    for (const char c : text)
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    return lines;
}

/// Tilts what is added next; a post after it stands upright again.
void tilt(ModelBuilder& builder, const RoadModel& model)
{
    const Tilt tilt = tiltOf(model);
    builder.place(tilt.turn, tilt.shift);
}

void uprightPost(ModelBuilder& builder, const RoadModel& model, double topM, double thick)
{
    builder.place(glm::dmat3(1.0), glm::dvec3(0.0));
    post(builder, model, topM, thick);
}

} // namespace

void addSign(ModelBuilder& builder, const RoadModel& model)
{
    Plate plate;
    plate.widthM = orElse(model.widthM, 0.6);
    plate.heightM = headHeightOf(model);
    plate.middle.x = -postRadiusOf(model) - plate.thicknessM;
    plate.middle.z = model.raisedM + 0.5 * plate.heightM;
    plate.shape = model.shape;
    plate.front =
        model.number > 0 ? cellOfLimit(model.number, model.face == SignFace::least) : cellOf(model.face);
    plate.back = model.isTwoSided ? plate.front : cellOf(SignFace::back);
    tilt(builder, model);
    builder.begin("plate", kPlain);
    addPlate(builder, plate);
    uprightPost(builder, model, model.raisedM + 0.9 * plate.heightM, postRadiusOf(model));
}

/// Adds a board: its face is rows of letters in a frame of plain cells, so nothing lies in front of anything.
void addBoard(ModelBuilder& builder, const RoadModel& model)
{
    const std::vector<std::string> lines = linesOf(model.text);
    std::size_t longest = 1;
    for (const std::string& line : lines)
        longest = std::max(longest, line.size());
    const double height = headHeightOf(model), rowM = height / static_cast<double>(lines.size());
    const double letter = std::min(lines.size() > 1 ? 0.8 * rowM : 0.6 * height,
                                   0.9 * orElse(model.widthM, 1e3) / static_cast<double>(longest));
    const double width = std::max(model.widthM, letter * static_cast<double>(longest) + 0.2);
    const double back = -postRadiusOf(model), low = model.raisedM;
    const glm::vec3 ground = model.isWhite ? glm::vec3(0.95F, 0.95F, 0.94F) : glm::vec3(0.98F, 0.82F, 0.10F);
    tilt(builder, model);
    builder.begin("plate", kPlain, ground);
    box(builder, {back - 0.03, -0.5 * width, low}, {back, 0.5 * width, low + height});
    builder.begin("letters", kPlain, ground);
    for (std::size_t row = 0; row < lines.size(); ++row)
    {
        const double middle = low + height - (static_cast<double>(row) + 0.5) * rowM;
        const double start = 0.5 * letter * static_cast<double>(lines[row].size());
        for (std::size_t i = 0; i < lines[row].size(); ++i)
        {
            if (lines[row][i] == ' ') continue;
            const SignCell cell = cellOfGlyph(lines[row][i]);
            const double left = start - letter * static_cast<double>(i);
            addBox(builder, {{back - 0.05, left - letter, middle - 0.5 * letter},
                             {back - 0.03, left, middle + 0.5 * letter},
                             {cell.high.x, cell.low.y},
                             {cell.low.x, cell.high.y},
                             1.0F});
        }
    }
    uprightPost(builder, model, low + height, postRadiusOf(model));
}

void addLights(ModelBuilder& builder, const RoadModel& model)
{
    const std::vector<Lens> lenses = lensesOf(model);
    const double top = lenses.front().middle.z + 0.5 * kLensStepM,
                 low = lenses.back().middle.z - 0.5 * kLensStepM;
    tilt(builder, model);
    builder.begin("housing", kPlain, kHousing);
    box(builder, {kLensX, -0.15, low}, {kLensX + kHeadDepthM, 0.15, top});
    builder.begin("lenses", kPlain);
    for (const Lens& lens : lenses)
        addPlate(builder, {lens.middle, 2.0 * lens.radiusM, 2.0 * lens.radiusM, 0.015,
                           RoadModel::Shape::round, cellOf(lens.face), cellOf(SignFace::back)});
    builder.begin("visors", kPlain, kHousing);
    for (const Lens& lens : lenses)
        box(builder, lens.middle + glm::dvec3(-0.18, -lens.radiusM, lens.radiusM),
            lens.middle + glm::dvec3(0.015, lens.radiusM, lens.radiusM + 0.012));
    uprightPost(builder, model, top, kLightPostM);
}

std::vector<Lens> lensesOf(const RoadModel& model)
{
    std::vector<SignFace> faces;
    if (model.kind == RoadModelKind::trafficLight)
        faces = {SignFace::lampRed, SignFace::lampAmber, SignFace::lampGreen};
    if (model.kind == RoadModelKind::pedestrianLight) faces = {SignFace::lampRed, SignFace::lampGreen};
    std::vector<Lens> lenses;
    for (std::size_t i = 0; i < faces.size(); ++i)
        lenses.push_back({{kLensX - 0.015, 0.0,
                           model.raisedM + kLensStepM * (static_cast<double>(faces.size() - i) - 0.5)},
                          0.105,
                          faces[i]});
    return lenses;
}

glm::dmat3 pitchAndRoll(double pitchRad, double rollRad)
{
    const double cp = std::cos(pitchRad), sp = std::sin(pitchRad), cr = std::cos(rollRad),
                 sr = std::sin(rollRad);
    const glm::dmat3 pitch(glm::dvec3(cp, 0.0, -sp), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(sp, 0.0, cp));
    const glm::dmat3 roll(glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, cr, sr), glm::dvec3(0.0, -sr, cr));
    return pitch * roll;
}

Tilt tiltOf(const RoadModel& model)
{
    if (model.pitchRad == 0.0 && model.rollRad == 0.0) return {};
    Tilt tilt{pitchAndRoll(model.pitchRad, model.rollRad), glm::dvec3(0.0)};
    const double heightM = headHeightOf(model);
    const glm::dvec3 middle(0.0, 0.0, model.raisedM + 0.5 * heightM);
    tilt.shift = middle - tilt.turn * middle;
    if (model.postDepthM > 0.0 && model.armM == 0.0)
        tilt.shift.x -= 0.5 * heightM * std::fabs(std::sin(model.pitchRad));
    return tilt;
}

} // namespace scenery::models
