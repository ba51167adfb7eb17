// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/CrossingNotes.h"

#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>

namespace worldmaking
{

namespace
{

std::string metresText(double metres)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f m", std::max(0.0, metres));
    return text;
}

/// Writes the notes of one network.
class NoteWriter
{
public:
    explicit NoteWriter(const CrossingFacts& facts) : _facts(facts) {}

    void addLost()
    {
        Kind kind("overpasses have too little headroom");
        for (const std::size_t i : _facts.heights.lost)
        {
            const Overpass& pass = _facts.crossings.overpasses[i];
            const double foundM = heightAt(pass.upper, pass.upperM) - heightAt(pass.lower, pass.lowerM);
            const double clearM = foundM - (pass.riseM - pass.clearM) + kRoundingM;
            add(kind, nameAt(pass.upper, pass.upperM) + " passes over " + nameAt(pass.lower, pass.lowerM) +
                          placeAt(pass.upper, pass.upperM) + " with " + metresText(clearM) +
                          " clear instead of " + metresText(pass.clearM) +
                          ": the map leaves no room for its ramps; " +
                          "join them farther from the crossing, or lower the one below");
        }
        close(kind);
    }

    void addLostCrossed()
    {
        Kind kind("streets pass too close over or under what they cross");
        std::set<std::pair<std::size_t, std::int64_t>> told; // a bridge over an area has many places
        for (const std::size_t i : _facts.heights.lostCrossed)
        {
            const CrossedPlace& place = _facts.crossings.crossed[i];
            if (!told.emplace(place.chain, place.way).second) continue;
            const char* what = place.kind == CrossedKind::path    ? "a path"
                               : place.kind == CrossedKind::water ? "water"
                                                                  : "a runway or taxiway";
            add(kind, nameAt(place.chain, place.alongM) + " passes " +
                          (place.isStreetAbove ? "over " : "under ") + what + " (way " +
                          std::to_string(place.way) + ")" + placeAt(place.chain, place.alongM) +
                          " less than " + metresText(place.apartM) +
                          " apart: the map leaves no room for its ramps; join it farther from the crossing");
        }
        close(kind);
    }

    void addTunnels()
    {
        Kind kind("tunnels stand above the ground");
        for (const BareTunnel& tunnel : _facts.heights.bareTunnels)
            add(kind, nameAt(tunnel.chain, tunnel.alongM) + ": its tunnel stands " + metresText(tunnel.byM) +
                          " above the ground" + placeAt(tunnel.chain, tunnel.alongM) +
                          ": the map leaves no room for its ramps; join it farther from the portals");
        close(kind);
    }

    void addImplied()
    {
        Kind kind("crossings are left open by the map");
        for (const Overpass& pass : _facts.crossings.leftOpen)
        {
            const auto isTram = [&](std::size_t chain, double alongM)
            { return traitsAt(chain, alongM).kind == "tram"; };
            if (isTram(pass.upper, pass.upperM) || isTram(pass.lower, pass.lowerM)) continue; // as everywhere
            const bool isRail =
                traitsAt(pass.upper, pass.upperM).isTrack != traitsAt(pass.lower, pass.lowerM).isTrack;
            add(kind,
                nameAt(pass.upper, pass.upperM) + " and " + nameAt(pass.lower, pass.lowerM) + " cross" +
                    placeAt(pass.upper, pass.upperM) +
                    " without a node in common, and the map does not say which one is above: they cross at " +
                    (isRail ? "one level, as a level crossing" : "one level") +
                    "; give them a common node, or one of them bridge=yes and a layer");
        }
        close(kind);
    }

    std::vector<std::string> notes;

private:
    /// Notes of one kind, counted.
    struct Kind
    {
        explicit Kind(std::string text) : more(std::move(text)) {}
        std::string more;
        std::size_t count = 0;
    };

    void add(Kind& kind, std::string text)
    {
        if (++kind.count <= kMostNotes) notes.push_back(std::move(text));
    }

    void close(const Kind& kind)
    {
        if (kind.count > kMostNotes)
            notes.push_back(std::to_string(kind.count) + " " + kind.more + " in all");
    }

    std::size_t pieceAt(std::size_t chain, double alongM) const
    {
        const auto& pointsM = _facts.lines[chain].pointsM();
        const auto next = std::upper_bound(pointsM.begin(), pointsM.end(), alongM);
        const auto piece = std::max<std::ptrdiff_t>(0, next - pointsM.begin() - 1);
        return std::min(static_cast<std::size_t>(piece), _facts.graph.chains[chain].pieces.size() - 1);
    }

    const StreetTraits& traitsAt(std::size_t chain, double alongM) const
    {
        return _facts.graph.traitsAt(_facts.graph.chains[chain], pieceAt(chain, alongM));
    }

    std::string nameAt(std::size_t chain, double alongM) const
    {
        const StreetTraits& traits = traitsAt(chain, alongM);
        const std::int64_t way = _facts.graph.chains[chain].pieces[pieceAt(chain, alongM)].way;
        const std::int64_t id = traits.isTrack ? _facts.trackId(static_cast<std::size_t>(way)) : way;
        return (traits.isTrack ? "railway" : "street") +
               (traits.name.empty() ? "" : " '" + traits.name + "'") + " (way " + std::to_string(id) + ")";
    }

    std::string placeAt(std::size_t chain, double alongM) const
    {
        const CentreLine& line = _facts.lines[chain];
        return " at " + _facts.placeText(line.at(std::clamp(alongM, 0.0, line.lengthM())).position);
    }

    double heightAt(std::size_t chain, double alongM) const
    {
        return _facts.heights.profiles[chain].elevation.value(
            std::max(0.0, alongM - _facts.cuts[chain].startM));
    }

    const CrossingFacts& _facts;
};

} // namespace

std::vector<std::string> crossingNotes(const CrossingFacts& facts)
{
    NoteWriter writer(facts);
    writer.addLost();
    writer.addLostCrossed();
    writer.addTunnels();
    writer.addImplied();
    return std::move(writer.notes);
}

} // namespace worldmaking
