// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/ReadObjects.h"

namespace scenery
{

namespace
{

using nlohmann::json;

constexpr std::size_t kMostSeeds = 1000;

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

} // namespace

void readObjects(JsonFields& parent, const std::filesystem::path& folder, std::vector<SceneryObject>& objects)
{
    Complaint& complaint = parent.complaint();
    const json* const list = parent.list("objects");
    if (!list || list->empty()) complaint.say(parent.at("objects"), "there are none", "give kinds or files");
    for (std::size_t i = 0; list && i < list->size(); ++i)
    {
        JsonFields fields((*list)[i], parent.at("objects") + "/" + std::to_string(i), complaint);
        std::string kind, file;
        std::vector<double> seeds;
        const bool isKind = fields.text("kind", kind), isFile = fields.text("file", file);
        if (!fields.numbers("seeds", seeds, 0.0, 9e15)) seeds.push_back(1.0);
        if (isKind == isFile || seeds.size() > kMostSeeds)
            complaint.say(fields.at("kind"), "has to be there, or file, and at most 1000 seeds", "give one");
        if (isFile) objects.push_back({{}, 0, (folder / file).string()});
        if (!isKind) continue;
        const auto known = kindOf(kind);
        if (!known) complaint.say(fields.at("kind"), "'" + kind + "' is none", "one of " + kindNames());
        for (const double seed : seeds)
            if (known) objects.push_back({known, static_cast<std::uint64_t>(seed), {}});
    }
}

} // namespace scenery
