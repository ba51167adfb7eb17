// SPDX-License-Identifier: Apache-2.0
// The looks of vehicles as files.
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "scenery/models/ModelCheck.h"
#include "scenery/models/Paint.h"
#include "scenery/models/entities/DefaultSize.h"
#include "scenery/models/entities/EntityModel.h"
#include "scenery/models/looks/BuiltInLooks.h"
#include "scenery/models/looks/VehicleLookFile.h"
#include "scenery/models/vehicles/Vehicle.h"

using namespace scenery::models;

namespace
{

const std::string kLooks = OSGTRAINER_SOURCE_DIR "/data/vehicles/looks/";

/// A small car with a steep back, as a user writes it.
const char* const kMine = R"({
 "name": "mine", "like": "estate", "seed": 7,
 "size": {"lengthM": 3.6, "widthM": 1.66, "heightM": 1.52},
 "colours": [[0.9, 0.6, 0.1]],
 "profile": {
  "top": [-1.8, 0.9,  -1.75, 1.2,  -1.6, 1.45,  0, 1.52,  0.5, 1.4,  1.1, 1.0,  1.7, 0.8,  1.8, 0.65],
  "belt": [-1.8, 0.8,  0, 0.95,  1.8, 0.6], "halfWidth": [-1.8, 0.7,  0, 0.83,  1.8, 0.6],
  "lean": [-1.8, 0.2,  1.8, 0.1], "bottom": [-1.8, 0.3,  0, 0.2,  1.8, 0.3]},
 "wheels": {"radiusM": 0.29, "widthM": 0.185, "archRadiusM": 0.33, "frontXM": 1.2, "rearXM": -1.2},
 "bounds": {"heightM": [1.4, 1.7], "radiusM": 2.2}
})";

std::string wholeText(const std::string& file)
{
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string errorIn(const std::string& text)
{
    const auto look = parseVehicleLook(text, "mine.json");
    return look ? "none" : look.error().message();
}

/// kMine with one text in place of another.
std::string changed(const std::string& from, const std::string& to)
{
    std::string text = kMine;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::shared_ptr<const VehicleLook> mine(const std::string& text = kMine)
{
    auto look = parseVehicleLook(text, "mine.json");
    EXPECT_TRUE(look) << (look ? "" : look.error().message());
    return look ? std::make_shared<const VehicleLook>(*std::move(look)) : builtInLook("saloon");
}

/// Which of its bounds some seed leaves; empty: none.
std::string leftBounds(const std::shared_ptr<const VehicleLook>& look)
{
    for (std::uint64_t seed = 0; seed < 40; ++seed)
    {
        const Model model = makeVehicle(look, seed);
        if (model.heightM < look->bounds.leastHeightM || model.heightM > look->bounds.mostHeightM)
            return "height";
        if (model.radiusM > look->bounds.mostRadiusM) return "radius";
    }
    return {};
}

} // namespace

TEST(BuiltInLooks, AreTheFilesOfTheTreeAndAllCanBeRead)
{
    std::set<std::string> names;
    for (const std::string_view name : builtInLookNames())
    {
        SCOPED_TRACE(name);
        names.emplace(name);
        const auto look = readVehicleLook(kLooks + std::string(name) + ".json");
        ASSERT_TRUE(look) << look.error().message();
        EXPECT_EQ(look->name, name);
        EXPECT_TRUE(wholeText(kLooks + std::string(name) + ".json").ends_with(builtInLookText(name)));
        EXPECT_EQ(leftBounds(builtInLook(name)), "");
    }
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(kLooks))
        files.insert(entry.path().stem().string());
    EXPECT_EQ(files, names);
    EXPECT_EQ(builtInLookText("coach"), "");
}

TEST(VehicleLook, AUsersFileIsAnotherSoundVehicleWithinItsBounds)
{
    const testsupport::TestFolder folder("own-look");
    const auto read = readVehicleLook(folder.write("mine.json", kMine));
    ASSERT_TRUE(read) << read.error().message();
    const auto look = std::make_shared<const VehicleLook>(*read);
    const Model model = makeVehicle(look, 1);
    EXPECT_EQ(defectOf(model), "");
    EXPECT_TRUE(isClosed(model.mesh, "body"));
    EXPECT_NE(model.mesh.positions, makeVehicle(builtInLook("estate"), 1).mesh.positions);
    EXPECT_EQ(leftBounds(look), "");
    // What it says stands, what it leaves out is the estate's.
    EXPECT_EQ(look->form.axles, glm::dvec2(1.2, -1.2));
    EXPECT_EQ(look->mirrors.head, builtInLook("saloon")->mirrors.head);
    EXPECT_EQ(look->marksOf(LookView::back).size(), builtInLook("estate")->marksOf(LookView::back).size());
}

TEST(VehicleLook, TheGuidesExampleIsASoundVan)
{
    const std::string page = wholeText(OSGTRAINER_SOURCE_DIR "/docs/guide/own-car.md");
    const std::size_t from = page.find("```json\n") + 8;
    const auto look = mine(page.substr(from, page.find("```", from) - from));
    EXPECT_EQ(look->name, "parcel van");
    EXPECT_EQ(defectOf(makeVehicle(look, 3)), "");
    EXPECT_EQ(leftBounds(look), "");
}

TEST(VehicleLook, ThePageHasEveryMember)
{
    const std::string page = wholeText(OSGTRAINER_SOURCE_DIR "/docs/reference/vehicle-look-file.md");
    std::size_t members = 0;
    for (const char* const part : {"", "size", "stretch", "bounds", "profile", "wheels", "mirrors",
                                   "headLamps", "tailLamps", "eye", "paint"})
    {
        SCOPED_TRACE(part);
        const std::string name(part), wrong = R"("unknownMember": 1)";
        const std::string error = errorIn(R"({"name": "x", "like": "van", )" +
                                          (name.empty() ? wrong : '"' + name + "\": {" + wrong + '}') + '}');
        const std::string known = "known: ";
        ASSERT_NE(error.find(known), std::string::npos) << error;
        std::istringstream words(error.substr(error.find(known) + known.size()));
        for (std::string word; words >> word; ++members)
        {
            if (word.back() == ',') word.pop_back();
            EXPECT_NE(page.find('`' + word + '`'), std::string::npos) << word;
        }
    }
    EXPECT_GT(members, 50U);
    for (const char* const word :
         {"glass", "fill", "box", "seam", "plate", "corner", "colour", "both", "repeat", "by", "black",
          "plastic", "lamp", "tailLamp", "amber", "chrome", "shade"})
        EXPECT_NE(page.find('`' + std::string(word) + '`'), std::string::npos) << word;
}

TEST(VehicleLook, BoundsThatAreTooNarrowWouldBeSeen)
{
    const auto look = mine();
    VehicleLook low = *look, thin = *look;
    low.bounds.mostHeightM = 1.5;
    thin.bounds.mostRadiusM = 1.9;
    EXPECT_EQ(leftBounds(std::make_shared<const VehicleLook>(low)), "height");
    EXPECT_EQ(leftBounds(std::make_shared<const VehicleLook>(thin)), "radius");
    EXPECT_EQ(leftBounds(mine(changed(",\n \"bounds\": {\"heightM\": [1.4, 1.7], \"radiusM\": 2.2}", ""))),
              "")
        << "bounds that follow from the size";
}

TEST(VehicleLook, AnEntityHasTheSheetTheLampsAndTheEyeOfItsLook)
{
    EntityShape shape;
    shape.kind = EntityKind::car;
    setDefaultSize(shape);
    const EntityModel before = makeEntityModel(shape);
    shape.look =
        mine(changed("\"seed\": 7", R"("headLamps": {"yM": 0.5, "zM": 0.7, "widthM": 0.1, "heightM": 0.1},
 "eye": {"alongShare": 0.5, "leftShare": 0.25, "upM": 1.1})"));
    const EntityModel after = makeEntityModel(shape);
    EXPECT_NE(after.meshes[0].mesh.positions, before.meshes[0].mesh.positions);
    EXPECT_EQ(after.meshes[0].surfaces[0].look, shape.look);
    EXPECT_DOUBLE_EQ(after.eye.y, 0.25 * shape.widthM);
    EXPECT_LT(after.lamps.front().middle.y, before.lamps.front().middle.y);
    for (const Model& mesh : after.meshes)
        EXPECT_EQ(defectOf(mesh), "");
}

TEST(VehicleLook, MarksArePaintedWhereTheyAre)
{
    const auto at = [](const std::string& marks)
    {
        const auto look = mine(changed("\"seed\": 7", "\"paint\": {\"front\": [" + marks + "]}"));
        const Picture picture = paint(Painting::vehicle, look.get());
        const VehicleSheet sheet(look->form);
        return [picture, sheet](float right, float up)
        {
            const glm::vec2 px = sheet.frontOriginPx() + glm::vec2(sheet.px(right), sheet.px(up));
            return static_cast<int>(picture.at(static_cast<int>(px.x), static_cast<int>(px.y))[0]);
        };
    };
    const auto box = at(R"({"box": [0.1, 0.4, 0.3, 0.6], "colour": [0.2, 0.2, 0.2, 0]})");
    EXPECT_EQ(box(0.2F, 0.5F), 51);
    EXPECT_EQ(box(-0.2F, 0.5F), 255) << "not painted";
    const auto both = at(R"({"box": [0.1, 0.4, 0.3, 0.6], "colour": [0.2, 0.2, 0.2, 0], "both": true})");
    EXPECT_EQ(both(-0.2F, 0.5F), 51);
    const auto repeated =
        at(R"({"box": [0.1, 0.4, 0.3, 0.5], "colour": [0.2, 0.2, 0.2, 0], "repeat": 3, "by": [0, 0.2]})");
    EXPECT_EQ(repeated(0.2F, 0.85F), 51);
    EXPECT_EQ(repeated(0.2F, 0.55F), 255) << "between two";
}

TEST(VehicleLook, DoorsOnOneSideMakeTwoSides)
{
    EXPECT_FALSE(mine()->form.hasTwoSides);
    EXPECT_TRUE(mine(changed("\"seed\": 7", R"("paint": {"right": [{"seam": [0, 0.3, 0, 0.9]}]})"))
                    ->form.hasTwoSides);
    EXPECT_TRUE(builtInLook("bus")->form.hasTwoSides);
}

TEST(VehicleLook, AMistakeIsToldWithPlaceAndRemedy)
{
    EXPECT_EQ(errorIn(kMine), "none");
    const auto tells = [](const std::string& text, const std::string& place, const std::string& what)
    {
        const std::string error = errorIn(text);
        EXPECT_NE(error.find("mine.json" + place), std::string::npos) << error;
        EXPECT_NE(error.find(what), std::string::npos) << error;
    };
    tells("{", ":1", "is no JSON");
    tells("[]", ": /", "is no object");
    tells("{\"name\": \"x\"}", ": /kind", "is missing");
    tells(changed("\"estate\"", "\"coach\""), ": /like", "one of saloon, estate, van, bus");
    tells(changed("\"seed\"", "\"sed\""), ": /sed", "known:");
    tells(changed("\"mine\"", "\"\""), ": /name", "give the look a name");
    tells(changed("0.9, 0.6, 0.1", "0.9, 0.6"), ": /colours/0", "[red, green, blue]");
    tells(changed("-1.75, 1.2", "-1.8, 1.2"), ": /profile/top/2", "let x rise");
    tells(changed("1.7, 0.8,", "1.9, 0.8,"), ": /profile/top/12", "beyond the vehicle's ends");
    tells(changed("0, 0.95", "0, 1.5"), ": /profile/top", "above the belt");
    tells(changed("0, 0.2,", "0, 0.9,"), ": /profile/belt", "above the lower edge");
    tells(changed("\"heightM\": 1.52", "\"heightM\": 1.7"), ": /bounds/heightM", "contain 1.649");
    tells(changed("\"frontXM\": 1.2", "\"frontXM\": 1.5"), ": /wheels/frontXM", "no room for the arch");
    tells(changed("\"archRadiusM\": 0.33", "\"archRadiusM\": 0.25"), ": /wheels/archRadiusM",
          "wheel's radius");
    tells(changed("\"radiusM\": 2.2", "\"radiusM\": 1.5"), ": /bounds/radiusM", "at least 2.07");
    const auto painted = [](const std::string& mark)
    { return changed("\"seed\": 7", "\"paint\": {\"top\": [" + mark + "]}"); };
    tells(painted("{\"colour\": \"lamp\"}"), ": /paint/top/0/glass", "give glass, fill, box, seam or plate");
    tells(painted("{\"fill\": [0, 0, 1, 0, 1, 1], \"colour\": \"red\"}"), ": /paint/top/0/colour",
          "one of black");
    tells(painted("{\"seam\": [0, 0, 1]}"), ": /paint/top/0/seam", "2 to 64 points");
    tells(painted("{\"box\": [1, 0, 0, 1], \"colour\": \"lamp\"}"), ": /paint/top/0/box", "has no area");
    tells(painted("{\"plate\": [0, 0], \"repeat\": 2}"), ": /paint/top/0/by", "write [right, up]");
    const auto none = readVehicleLook("/nowhere/mine.json");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message().find("/nowhere/mine.json"), std::string::npos);
}
