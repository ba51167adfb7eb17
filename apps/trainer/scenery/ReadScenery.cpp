// SPDX-License-Identifier: Apache-2.0
#include "scenery/ReadScenery.h"

#include <array>
#include <fstream>
#include <iterator>
#include <set>

#include "scenery/JsonFields.h"
#include "scenery/ReadSelection.h"

namespace trainer::scenery
{

namespace
{

using nlohmann::json;

constexpr std::size_t kMostBytes = 4u << 20u, kMostFields = 1000, kMostSeeds = 1000;
constexpr double kFarM = 1e8;
constexpr std::array kArrangements{"settlement", "parked", "rows", "scattered"};

void readSpan(JsonFields& parent, const char* name, Span& span, double least, double most)
{
    std::vector<double> ends;
    if (!parent.numbers(name, ends, least, most)) return;
    if (ends.size() != 2 || !(ends[0] <= ends[1]))
        return parent.complaint().say(parent.at(name), "is no range", "write [least, most]");
    span = {ends[0], ends[1]};
}

void readCircle(JsonFields& parent, std::optional<Circle>& circle)
{
    const json* const found = parent.find("circle");
    if (!found) return;
    JsonFields fields(*found, parent.at("circle"), parent.complaint());
    circle.emplace();
    fields.number("eastM", circle->centreM.x, -kFarM, kFarM);
    fields.number("northM", circle->centreM.y, -kFarM, kFarM);
    if (!fields.number("radiusM", circle->radiusM, 1.0, kFarM))
        fields.complaint().say(fields.at("radiusM"), "is missing", "give metres");
}

void readPolygon(JsonFields& parent, std::vector<glm::dvec2>& polygon)
{
    std::vector<double> numbers;
    if (!parent.numbers("polygonM", numbers, -kFarM, kFarM)) return;
    if (numbers.size() < 6 || numbers.size() % 2 != 0)
        return parent.complaint().say(parent.at("polygonM"), "is no polygon",
                                      "write [east, north, east, north, east, north …]");
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        polygon.emplace_back(numbers[i], numbers[i + 1]);
}

void readWhere(JsonFields& parent, Where& where)
{
    const json* const found = parent.find("where");
    if (!found) return;
    JsonFields fields(*found, parent.at("where"), parent.complaint());
    readCircle(fields, where.circle);
    readPolygon(fields, where.polygon);
    Span path;
    readSpan(fields, "pathDistanceM", path, 0.0, kFarM);
    if (path.least >= 0.0) where.pathDistanceM = path;
    readSpan(fields, "heightM", where.heightM, -kFarM, kFarM);
    readSpan(fields, "slopeDeg", where.slopeDeg, 0.0, 90.0);
    fields.flag("inWater", where.inWater);
    fields.number("patchM", where.patchM, 1.0, kFarM);
    fields.number("patchShare", where.patchShare, 0.0, 1.0);
    const json* const covers = fields.list("covers");
    for (std::size_t i = 0; covers && i < covers->size(); ++i)
        if ((*covers)[i].is_string())
            where.covers.push_back((*covers)[i].get<std::string>());
        else
            fields.complaint().say(fields.at("covers"), "has something that is no text", "write names");
}

std::optional<models::Kind> kindOf(const std::string& name)
{
    for (const models::KindFacts& facts : models::kinds())
        if (facts.name == name) return facts.kind;
    return std::nullopt;
}

std::string kindNames()
{
    std::string names;
    for (const models::KindFacts& facts : models::kinds())
        names += (names.empty() ? "" : ", ") + std::string(facts.name);
    return names;
}

class Reader
{
public:
    Reader(const std::filesystem::path& name, Complaint& complaint)
        : _folder(name.parent_path()), _complaint(complaint)
    {
    }

    SceneryDescription description(const json& root)
    {
        SceneryDescription description;
        JsonFields fields(root, "", _complaint);
        fields.whole("seed", description.seed, 0.0, 9e15);
        readBudget(fields, description.budget);
        const json* const list = fields.list("fields");
        if (!list || list->size() > kMostFields)
            _complaint.say("/fields", "there are none, or too many",
                           "give up to " + std::to_string(kMostFields));
        std::set<std::string> names;
        for (std::size_t i = 0; list && i < list->size() && !_complaint.error; ++i)
        {
            const std::string pointer = "/fields/" + std::to_string(i);
            description.fields.push_back(field((*list)[i], pointer));
            if (!names.insert(description.fields.back().name).second)
                _complaint.say(pointer + "/name", "another field has this name", "give each one of its own");
        }
        checkNeighbours(description);
        return description;
    }

private:
    SceneryField field(const json& object, const std::string& pointer)
    {
        SceneryField field;
        JsonFields fields(object, pointer, _complaint);
        if (!fields.text("name", field.name) || field.name.empty())
            _complaint.say(pointer + "/name", "is missing or empty", "give the field a name");
        fields.choice("arrangement", field.arrangement, kArrangements);
        readObjects(fields, field.objects);
        const bool hasCount = fields.whole("count", field.count, 1.0, 1e7);
        const bool hasDensity = fields.number("densityPerKm2", field.densityPerKm2, 1e-6, 1e7);
        const bool isCounted = field.arrangement != Arrangement::settlement;
        if (isCounted && hasCount == hasDensity)
            _complaint.say(pointer + "/count", "either count or densityPerKm2 has to be there", "give one");
        readWhere(fields, field.where);
        readLayouts(fields, field);
        fields.text("beside", field.beside);
        fields.number("spacingM", field.spacingM, 0.0, 1e4);
        fields.number("crowding", field.crowding, 0.0, 0.8);
        Span scale{1.0, 1.0};
        readSpan(fields, "scale", scale, 0.01, 100.0);
        field.leastScale = scale.least;
        field.mostScale = scale.most;
        readSelection(fields, field.selection);
        readSwitching(fields, field.switching);
        fields.number("importance", field.importance, 0.01, 100.0);
        const Where& where = field.where;
        if (!where.circle && where.polygon.empty() && !where.pathDistanceM)
            _complaint.say(pointer + "/where", "does not say where",
                           "give circle, polygonM or pathDistanceM");
        return field;
    }

    void readObjects(JsonFields& parent, std::vector<SceneryObject>& objects)
    {
        const json* const list = parent.list("objects");
        if (!list || list->empty())
            _complaint.say(parent.at("objects"), "there are none", "give kinds or files");
        for (std::size_t i = 0; list && i < list->size(); ++i)
        {
            JsonFields fields((*list)[i], parent.at("objects") + "/" + std::to_string(i), _complaint);
            std::string kind, file;
            std::vector<double> seeds;
            const bool isKind = fields.text("kind", kind), isFile = fields.text("file", file);
            if (!fields.numbers("seeds", seeds, 0.0, 9e15)) seeds.push_back(1.0);
            if (isKind == isFile || seeds.size() > kMostSeeds)
                _complaint.say(fields.at("kind"), "has to be there, or file, and at most 1000 seeds",
                               "give one");
            if (isFile) objects.push_back({{}, 0, (_folder / file).string()});
            if (!isKind) continue;
            const auto known = kindOf(kind);
            if (!known) _complaint.say(fields.at("kind"), "'" + kind + "' is none", "one of " + kindNames());
            for (const double seed : seeds)
                if (known) objects.push_back({known, static_cast<std::uint64_t>(seed), {}});
        }
    }

    void readLayouts(JsonFields& parent, SceneryField& field)
    {
        if (const json* const found = parent.find("rows"))
        {
            JsonFields fields(*found, parent.at("rows"), _complaint);
            fields.number("spacingM", field.rows.spacingM, 0.5, 1000.0);
            fields.number("betweenM", field.rows.betweenM, 0.5, 1000.0);
            fields.number("lengthM", field.rows.lengthM, 1.0, 1e4);
            fields.whole("rows", field.rows.rows, 1.0, 100.0);
        }
        if (const json* const found = parent.find("settlement"))
        {
            JsonFields fields(*found, parent.at("settlement"), _complaint);
            fields.whole("settlements", field.settlement.settlements, 1.0, 1000.0);
            fields.whole("sideStreets", field.settlement.sideStreets, 0.0, 100.0);
            fields.number("streetM", field.settlement.streetM, 10.0, 1e4);
            fields.number("plotM", field.settlement.plotM, 5.0, 1000.0);
            fields.number("setbackM", field.settlement.setbackM, 0.5, 1000.0);
            fields.number("widthM", field.settlement.widthM, 2.0, 100.0);
        }
    }

    void checkNeighbours(const SceneryDescription& description)
    {
        for (std::size_t i = 0; i < description.fields.size(); ++i)
        {
            const SceneryField& field = description.fields[i];
            if (field.arrangement != Arrangement::parked) continue;
            const auto isIt = [&](const SceneryField& other)
            { return other.arrangement == Arrangement::settlement && other.name == field.beside; };
            if (std::none_of(description.fields.begin(), description.fields.end(), isIt))
                _complaint.say("/fields/" + std::to_string(i) + "/beside", "names no settlement",
                               "give the name of a field that is one");
        }
    }

    std::filesystem::path _folder;
    Complaint& _complaint;
};

} // namespace

std::vector<SceneryObject> objectsOf(const SceneryDescription& description)
{
    std::vector<SceneryObject> all;
    for (const SceneryField& field : description.fields)
        for (const SceneryObject& object : field.objects)
            if (std::find(all.begin(), all.end(), object) == all.end()) all.push_back(object);
    return all;
}

viewlod::Result<SceneryDescription> parseScenery(std::string_view text, const std::filesystem::path& name)
{
    if (text.size() > kMostBytes)
        return viewlod::Error{name.string(), "is larger than 4 MB", "give a description of the scenery"};
    json root;
    try
    {
        root = json::parse(text, nullptr, true, true);
    }
    catch (const json::exception& failure) // the library's way to say so; it ends here
    {
        const auto* const parsing = dynamic_cast<const json::parse_error*>(&failure);
        const std::size_t byte = parsing ? std::min(parsing->byte, text.size()) : 0;
        const auto line =
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
        return viewlod::Error{name.string() + ":" + std::to_string(line), "is no JSON",
                              "look for a comma or a bracket before this place"};
    }
    Complaint complaint{name.string(), {}};
    SceneryDescription description = Reader(name, complaint).description(root);
    if (complaint.error) return *complaint.error;
    return description;
}

viewlod::Result<SceneryDescription> readScenery(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string text(kMostBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    if (text.empty())
        return viewlod::Error{file.string(), "cannot be read or is empty", "give a scenery's JSON file"};
    return parseScenery(text, file);
}

} // namespace trainer::scenery
