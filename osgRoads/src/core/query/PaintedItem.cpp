// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <string_view>

#include <foundation/SmallLetters.h>

#include <osgRoads/core/query/PaintedItem.h>

namespace osgRoads::core
{

namespace
{

bool has(const std::string& words, std::string_view part)
{
    return words.find(part) != std::string::npos;
}

std::optional<PaintKind> kindByWords(const std::string& words)
{
    if (has(words, "crosswalk") || has(words, "zebra")) return PaintKind::crosswalk;
    if (has(words, "arrow")) return PaintKind::arrow;
    if (has(words, "yieldline") || has(words, "waitingline")) return PaintKind::yieldLine;
    if (has(words, "stopline") || has(words, "holdingline") || has(words, "signallines"))
        return PaintKind::stopLine;
    return {};
}

} // namespace

std::optional<PaintKind> paintKind(const Signal& signal)
{
    if (signal.type == "293" || signal.type == "1000003") return PaintKind::crosswalk;
    if (signal.type == "294") return PaintKind::stopLine;
    if (signal.type == "297") return PaintKind::arrow;
    if (signal.type == "341") return PaintKind::yieldLine;
    const std::string name = foundation::inSmallLetters(signal.name);
    // Models of road marks of VIRES, as SgRMArrowLeft.flt.
    if (name.starts_with("sgrm")) return kindByWords(name);
    return {};
}

std::optional<PaintKind> paintKind(const RoadObject& object)
{
    const std::string type = foundation::inSmallLetters(object.type);
    if (type == "crosswalk") return PaintKind::crosswalk;
    if (type == "parkingspace") return PaintKind::parkingSpace;
    if (type == "patch") return PaintKind::patch;
    if (type != "roadmark") return {};
    return kindByWords(foundation::inSmallLetters(object.subtype + " " + object.name))
        .value_or(PaintKind::area);
}

ArrowHeads arrowHeads(const RoadItem& item)
{
    const std::string words = foundation::inSmallLetters(item.subtype + " " + item.name);
    ArrowHeads heads;
    if (has(words, "merge"))
    {
        heads.ahead = true;
        heads.merge = has(words, "right") ? -1 : 1;
        return heads;
    }
    heads.left = has(words, "left");
    heads.right = has(words, "right");
    heads.ahead = has(words, "straight") || has(words, "ahead") || (!heads.left && !heads.right);
    return heads;
}

} // namespace osgRoads::core
