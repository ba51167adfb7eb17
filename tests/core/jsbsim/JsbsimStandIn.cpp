// SPDX-License-Identifier: Apache-2.0
// Speaks JSBSim's protocol as Debian's JSBSim does, over a point that flies straight: 5 m/s down for each
// unit of the elevator's command, along with the wind. The name of the aircraft says how it behaves: normal,
// hang, dies, signal, garbage, nan, leap, clock, slow, mute, silent, notrim, port.
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace
{

constexpr double kStepS = 1.0 / 120.0, kFootM = 0.3048, kSeaFt = 6378137.0 / kFootM;
constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr int kFaultAt = 60; // iterations

std::string fileText(const std::string& path)
{
    std::ifstream stream(path);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// What stands after `before`, up to the next of `ends`.
std::string after(const std::string& text, const std::string& before, const char* ends)
{
    const std::size_t at = text.find(before);
    if (at == std::string::npos) return {};
    const std::size_t begin = at + before.size();
    return text.substr(begin, text.find_first_of(ends, begin) - begin);
}

double element(const std::string& text, const std::string& name)
{
    return std::atof(
        after(text, "<" + name + " unit=\"" + after(text, "<" + name + " unit=\"", "\"") + "\">", "<")
            .c_str());
}

struct StandIn
{
    std::string mode;
    FILE* rows = nullptr;
    int client = -1;
    std::map<std::string, double> properties;
    std::vector<std::string> asked;                          ///< those of the script that there are
    double timeS = 0.0, north = 0.0, east = 0.0, down = 0.0; // ft/s
    double latitude = 0.0, longitude = 0.0, height = 0.0;    // rad, ft
    double heading = 0.0;
    int iterations = 0;

    void advance()
    {
        timeS += kStepS;
        const double n = north + properties["atmosphere/wind-north-fps"],
                     e = east + properties["atmosphere/wind-east-fps"];
        const double d = down + properties["fcs/elevator-cmd-norm"] * 5.0 / kFootM;
        latitude += kStepS * n / (kSeaFt + height);
        longitude += kStepS * e / ((kSeaFt + height) * std::cos(latitude));
        height -= kStepS * d;
        // Near the ground it sinks until its wheels carry it.
        const double lowest = properties["position/terrain-elevation-asl-ft"] + 4.0;
        if (height < lowest + 1.0) height -= 0.01;
        height = std::max(height, lowest);
    }

    void writeRow() const
    {
        const double r = kSeaFt + height;
        const bool onGround = height <= properties.at("position/terrain-elevation-asl-ft") + 4.0;
        const double factor = mode == "leap" && iterations > kFaultAt ? 1.01 : 1.0;
        const double n = north + properties.at("atmosphere/wind-north-fps"),
                     e = east + properties.at("atmosphere/wind-east-fps");
        const double d = onGround ? 0.0 : down + properties.at("fcs/elevator-cmd-norm") * 5.0 / kFootM;
        std::fprintf(rows, "%.10g,%.18g,%.18g,%.18g,%.18g,%.18g,%.18g,0,0,%.18g,0,0,0,%.18g,%d,%d,%d", timeS,
                     factor * r * std::cos(latitude) * std::cos(longitude),
                     factor * r * std::cos(latitude) * std::sin(longitude), factor * r * std::sin(latitude),
                     n, e, mode == "nan" && iterations > kFaultAt ? std::nan("") : d, heading, height,
                     onGround, onGround, onGround);
        for (const std::string& property : asked)
            std::fprintf(rows, ",%.18g", properties.at(property));
        std::fprintf(rows, "\n");
        std::fflush(rows);
    }

    void say(const std::string& text) const
    {
        if (::send(client, text.data(), text.size(), MSG_NOSIGNAL) < 0) std::exit(0);
        if (::send(client, "JSBSim> ", 8, MSG_NOSIGNAL) < 0) std::exit(0);
    }

    void misbehave()
    {
        if (mode == "slow") std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (iterations <= kFaultAt) return;
        if (mode == "hang")
            for (;;)
                pause();
        if (mode == "dies") std::exit(3);
        if (mode == "signal") std::raise(SIGSEGV);
        if (mode == "garbage") std::fprintf(rows, "<html>not a row</html>\n");
        if (mode == "clock") timeS += kStepS;
    }

    void answer(const std::string& line, bool& runs)
    {
        std::istringstream words(line);
        std::string order, property;
        double value = 0.0;
        words >> order >> property >> value;
        if (order == "iterate")
        {
            runs = true;
            ++iterations;
            misbehave();
            say("Iterations performed\n");
        }
        else if (!properties.contains(property))
            say("Unknown property\n");
        else if (order == "set")
        {
            properties[property] = value;
            say("set successful\n");
        }
        else
        {
            char text[200];
            std::snprintf(text, sizeof text, "%s = %12.6g\n", property.c_str(), properties[property]);
            say(text);
        }
    }

    /// One frame after the other, each with the orders that wait for it.
    void run()
    {
        bool isHeld = true, isStepPending = false;
        for (;;)
        {
            if (isStepPending) advance();
            char bytes[65536];
            const ssize_t got = recv(client, bytes, sizeof bytes, 0);
            if (got <= 0) std::exit(0);
            bool runs = false;
            std::istringstream lines(std::string(bytes, static_cast<std::size_t>(got)));
            for (std::string line; std::getline(lines, line);)
                answer(line, runs);
            if (!isHeld || runs) writeRow();
            isStepPending = runs;
            isHeld = !runs;
        }
    }
};

int listenAt(int port)
{
    const int file = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    if (bind(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 || listen(file, 1) != 0)
        return -1;
    return accept(file, nullptr, nullptr);
}

struct Arguments
{
    std::string script, root;
};

Arguments argumentsOf(int argc, char** argv)
{
    Arguments arguments;
    for (int i = 1; i < argc; ++i)
    {
        const std::string option = argv[i];
        if (option.starts_with("--script=")) arguments.script = fileText(option.substr(9));
        if (option.starts_with("--root=")) arguments.root = option.substr(7);
    }
    return arguments;
}

/// Gives a point the properties that there are, and the state of its file.
void setUp(StandIn& point, const std::string& state)
{
    for (const char* name :
         {"fcs/elevator-cmd-norm", "fcs/aileron-cmd-norm", "fcs/throttle-cmd-norm", "fcs/left-brake-cmd-norm",
          "position/terrain-elevation-asl-ft", "atmosphere/wind-north-fps", "atmosphere/wind-east-fps",
          "atmosphere/wind-down-fps", "ap/heading_hold", "inertia/cg-x-in", "inertia/cg-y-in",
          "inertia/cg-z-in"})
        point.properties[name] = 0.0;
    const double places[3][3] = {{-40.0, 0.0, -48.0}, {20.0, -40.0, -48.0}, {20.0, 40.0, -48.0}};
    for (int i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis)
            point.properties[std::string("gear/unit") + (i > 0 ? "[" + std::to_string(i) + "]" : "") + "/" +
                             "xyz"[axis] + "-position"] = places[i][axis];
    point.latitude = kDegree * element(state, "latitude");
    point.longitude = kDegree * element(state, "longitude");
    point.height = element(state, "altitudeMSL");
    point.properties["position/terrain-elevation-asl-ft"] = element(state, "elevation");
    point.north = element(state, "vnorth");
    point.east = element(state, "veast");
    point.heading = kDegree * element(state, "psi");
}

/// Opens the file of rows; writes the names of their columns, the last of them those that the script asks
/// for, and the first two rows.
void beginRows(StandIn& point, const std::string& script)
{
    point.rows = std::fopen("/dev/fd/3", "w");
    std::fprintf(
        point.rows,
        "Time,/fdm/jsbsim/position/ecef-x-ft,/fdm/jsbsim/position/ecef-y-ft,/fdm/jsbsim/position/ecef-z-ft,"
        "/fdm/jsbsim/velocities/v-north-fps,/fdm/jsbsim/velocities/v-east-fps,/fdm/jsbsim/velocities/"
        "v-down-fps,"
        "/fdm/jsbsim/attitude/phi-rad,/fdm/jsbsim/attitude/theta-rad,/fdm/jsbsim/attitude/psi-rad,"
        "/fdm/jsbsim/velocities/p-rad_sec,/fdm/jsbsim/velocities/q-rad_sec,/fdm/jsbsim/velocities/r-rad_sec,"
        "/fdm/jsbsim/position/h-sl-ft,/fdm/jsbsim/gear/unit/WOW,/fdm/jsbsim/gear/unit[1]/WOW,"
        "/fdm/jsbsim/gear/unit[2]/WOW");
    const std::string tag = "<property>";
    for (std::size_t at = script.find(tag); at != std::string::npos; at = script.find(tag, at + 1))
        if (const std::string property = after(script.substr(at), tag, "<");
            point.properties.contains(property))
            point.asked.push_back(property);
    for (const std::string& property : point.asked)
        std::fprintf(point.rows, ",/fdm/jsbsim/%s", property.c_str());
    std::fprintf(point.rows, "\n");
    point.writeRow();
    point.advance();
    point.writeRow();
}

} // namespace

int main(int argc, char** argv)
{
    const auto [script, root] = argumentsOf(argc, argv);
    StandIn point;
    point.mode = after(script, "aircraft=\"", "\"");
    const std::string state = fileText(after(script, "initialize=\"", "\""));
    if (point.mode == "notrim" && script.find("do_simple_trim") != std::string::npos)
    {
        std::printf("  Trim failed\n\nFATAL ERROR: it ends with an exception.\n");
        return 1;
    }
    if (point.mode == "mute")
        for (;;)
            pause();
    setUp(point, state);
    beginRows(point, script);
    const std::string marker = root + "/port-was-lost";
    if (point.mode == "port" && access(marker.c_str(), F_OK) != 0)
    {
        // Another program has the port, and answers there; this one goes on without.
        std::ofstream(marker) << "1";
        std::fprintf(stderr, "Could not bind to TCP input socket, error = 98\n");
    }
    point.client = listenAt(std::atoi(after(script, "<input port=\"", "\"").c_str()));
    if (point.client < 0) return 2;
    if (point.mode == "silent")
        for (;;)
            pause();
    point.say("Connected to JSBSim server\n");
    point.run();
}
