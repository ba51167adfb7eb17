// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/looks/ReadLookPaint.h"

#include <array>
#include <string>
#include <vector>

#include "scenery/models/looks/ReadLookShape.h"
#include "scenery/models/paint/VehiclePainter.h"

namespace scenery::models
{

namespace
{

using nlohmann::json;

constexpr double kFarthestPointM = 20.0, kMostRepeats = 100.0;
constexpr std::size_t kMostCorners = 64, kMostMarks = 300;

struct NamedColour
{
    const char* name;
    glm::vec4 colour;
};
constexpr std::array kNamed{
    NamedColour{"black", VehiclePainter::kBlack}, NamedColour{"plastic", VehiclePainter::kPlastic},
    NamedColour{"lamp", VehiclePainter::kLamp},   NamedColour{"tailLamp", VehiclePainter::kTailLamp},
    NamedColour{"amber", VehiclePainter::kAmber}, NamedColour{"chrome", VehiclePainter::kChrome},
    NamedColour{"shade", VehiclePainter::kShade}, NamedColour{"glass", VehiclePainter::kGlass}};

/// A kind of mark, and how many points it has.
struct MarkWord
{
    const char* word;
    LookMark::Kind kind;
    std::size_t least, most;
    bool hasColour;
};
constexpr std::array kMarkWords{MarkWord{"glass", LookMark::Kind::glass, 3, kMostCorners, false},
                                MarkWord{"fill", LookMark::Kind::fill, 3, kMostCorners, true},
                                MarkWord{"box", LookMark::Kind::box, 2, 2, true},
                                MarkWord{"seam", LookMark::Kind::seam, 2, kMostCorners, false},
                                MarkWord{"plate", LookMark::Kind::plate, 1, 1, false}};

void readMarkColour(JsonFields& fields, glm::vec4& colour)
{
    const json* const found = fields.find("colour");
    if (!found) return fields.complaint().say(fields.at("colour"), "is missing", "give a colour");
    if (!found->is_string()) return readColour(*found, fields.at("colour"), fields.complaint(), colour);
    std::string all;
    for (const NamedColour& named : kNamed)
    {
        if (*found == named.name)
        {
            colour = named.colour;
            return;
        }
        all += (all.empty() ? "" : ", ") + std::string(named.name);
    }
    fields.complaint().say(fields.at("colour"), "'" + found->get<std::string>() + "' is none",
                           "one of " + all);
}

void readStep(JsonFields& fields, glm::vec2& step)
{
    std::vector<double> by;
    if (!fields.numbers("by", by, -kFarthestPointM, kFarthestPointM) || by.size() != 2)
        return fields.complaint().say(fields.at("by"), "is no way from one to the next", "write [right, up]");
    step = {static_cast<float>(by[0]), static_cast<float>(by[1])};
}

/// Reads the points of the one kind that the mark names.
const MarkWord* readPoints(JsonFields& fields, LookMark& mark)
{
    const MarkWord* found = nullptr;
    for (const MarkWord& word : kMarkWords)
    {
        std::vector<double> numbers;
        if (!fields.numbers(word.word, numbers, -kFarthestPointM, kFarthestPointM)) continue;
        if (found) fields.complaint().say(fields.at(word.word), "is a second kind", "make two marks of it");
        found = &word;
        mark.kind = word.kind;
        if (numbers.size() % 2 != 0 || numbers.size() < 2 * word.least || numbers.size() > 2 * word.most)
            fields.complaint().say(fields.at(word.word), "has another number of points",
                                   "write [right, up, right, up …], " + std::to_string(word.least) + " to " +
                                       std::to_string(word.most) + " points");
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            mark.points.emplace_back(static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1]));
    }
    if (!found)
        fields.complaint().say(fields.at(kMarkWords.front().word), "is missing, and every other kind",
                               "give glass, fill, box, seam or plate");
    return found;
}

LookMark readMark(const json& object, const std::string& place, Complaint& complaint)
{
    JsonFields fields(object, place, complaint);
    LookMark mark;
    const MarkWord* const word = readPoints(fields, mark);
    if (word && word->hasColour) readMarkColour(fields, mark.colour);
    double cornerM = 0.0;
    if (mark.kind == LookMark::Kind::box && fields.number("corner", cornerM, 0.0, 1.0))
        mark.cornerM = static_cast<float>(cornerM);
    fields.flag("both", mark.isOnBothSides);
    if (fields.whole("repeat", mark.repeats, 1.0, kMostRepeats)) readStep(fields, mark.step);
    if (mark.kind == LookMark::Kind::box && mark.points.size() == 2 &&
        (mark.points[0].x >= mark.points[1].x || mark.points[0].y >= mark.points[1].y))
        complaint.say(place + "/box", "has no area", "write [left, low, right, high]");
    return mark;
}

} // namespace

void readLookPaint(JsonFields& root, VehicleLook& look)
{
    static constexpr std::array kViews{"sides", "right", "left", "top", "front", "back"};
    static_assert(kViews.size() == static_cast<std::size_t>(LookView::count));
    readPart(root, "paint",
             [&](JsonFields& fields)
             {
                 for (std::size_t view = 0; view < kViews.size(); ++view)
                 {
                     const json* const list = fields.list(kViews[view]);
                     if (list && list->size() > kMostMarks)
                         fields.complaint().say(fields.at(kViews[view]), "has more than 300 marks",
                                                "leave some out");
                     for (std::size_t i = 0; list && i < list->size() && !fields.complaint().error; ++i)
                         look.paint[view].push_back(
                             readMark((*list)[i], fields.at(kViews[view]) + "/" + std::to_string(i),
                                      fields.complaint()));
                 }
             });
    look.form.hasTwoSides = !look.marksOf(LookView::right).empty() || !look.marksOf(LookView::left).empty();
}

} // namespace scenery::models
