// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

/// A small map in the text of OpenStreetMap. Nodes are placed in metres east and north of 42.5° N 1.5° E; the
/// first has the id 1.
class MadeMap
{
public:
    static constexpr double kLatitudeDeg = 42.5, kLongitudeDeg = 1.5;
    static constexpr double kMetresPerDegree = 111000.0;

    using MapTags = std::vector<std::pair<const char*, const char*>>;

    int node(double eastM, double northM, const MapTags& tags = {})
    {
        const double latitude = kLatitudeDeg + northM / kMetresPerDegree;
        const double longitude =
            kLongitudeDeg + eastM / (kMetresPerDegree * std::cos(kLatitudeDeg * 3.14159265358979 / 180.0));
        _nodes += "<node id=\"" + std::to_string(++_lastNode) + "\" lat=\"" + std::to_string(latitude) +
                  "\" lon=\"" + std::to_string(longitude) + "\">" + textOf(tags) + "</node>\n";
        return _lastNode;
    }

    /// Returns the id of the way, from 1.
    int way(const std::vector<int>& nodes, const MapTags& tags = {{"highway", "residential"}})
    {
        _ways += "<way id=\"" + std::to_string(++_lastWay) + "\">";
        for (const int node : nodes)
            _ways += "<nd ref=\"" + std::to_string(node) + "\"/>";
        _ways += textOf(tags) + "</way>\n";
        return _lastWay;
    }

    void rule(const char* kind, int from, int via, int to)
    {
        const auto member = [](const char* type, int ref, const char* role)
        {
            return std::string("<member type=\"") + type + "\" ref=\"" + std::to_string(ref) + "\" role=\"" +
                   role + "\"/>";
        };
        _rules += "<relation id=\"" + std::to_string(++_lastRule) + "\">" + member("way", from, "from") +
                  member("node", via, "via") + member("way", to, "to") + "<tag k=\"restriction\" v=\"" +
                  kind + "\"/></relation>\n";
    }

    std::string text() const
    {
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<osm version=\"0.6\">\n" + _nodes + _ways +
               _rules + "</osm>\n";
    }

private:
    static std::string textOf(const MapTags& tags)
    {
        std::string text;
        for (const auto& [key, value] : tags)
            text += std::string("<tag k=\"") + key + "\" v=\"" + value + "\"/>";
        return text;
    }

    std::string _nodes, _ways, _rules;
    int _lastNode = 0, _lastWay = 0, _lastRule = 0;
};
