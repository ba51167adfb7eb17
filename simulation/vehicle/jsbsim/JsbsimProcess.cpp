// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/JsbsimProcess.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <arpa/inet.h>
#include <foundation/Excerpt.h>
#include <foundation/WholeFile.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "simulation/vehicle/jsbsim/JsbsimLastWords.h"

namespace simulation
{
namespace
{

constexpr std::string_view kPrompt = "JSBSim> ";
constexpr double kStepS = 1.0 / JsbsimProcess::kStepsPerSecond;

sockaddr_in loopback(int port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
}

/// A port that nobody listens at now; 0: none can be had.
int freePort()
{
    const int file = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof address;
    int port = 0;
    if (file >= 0 && bind(file, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
        getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) == 0)
        port = ntohs(address.sin_port);
    if (file >= 0) close(file);
    return port;
}

/// A connection to a port of this machine; -1: nobody listens there.
int connectTo(int port)
{
    const int file = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (file < 0) return -1;
    const sockaddr_in address = loopback(port);
    const int yes = 1;
    setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    if (connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return file;
    close(file);
    return -1;
}

foundation::Outcome checkRoot(const JsbsimData& data)
{
    const std::filesystem::path file = data.root / "aircraft" / data.aircraft / (data.aircraft + ".xml");
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored)) return foundation::success();
    return foundation::Error{file.string(), "JSBSim's root has no such aircraft",
                             "name a root with aircraft/NAME/NAME.xml, and one of its aircraft"};
}

} // namespace

JsbsimProcess::JsbsimProcess(const JsbsimData& data, std::vector<std::string> asked, TemporaryFolder folder,
                             ChildProcess child)
    : _data(data),
      _folder(std::move(folder)),
      _child(std::move(child)),
      _rows(_child.pipe()),
      _asked(std::move(asked)),
      _patienceS(data.beginsWithinS)
{
}

JsbsimProcess::~JsbsimProcess()
{
    if (_socket >= 0) close(_socket);
}

foundation::Result<std::unique_ptr<JsbsimProcess>> JsbsimProcess::start(const JsbsimData& data,
                                                                        const JsbsimStart& start)
{
    if (const auto sound = checkRoot(data); !sound) return sound.error();
    constexpr int kTries = 3; // of ports
    foundation::Error last;
    for (int i = 0; i < kTries; ++i)
    {
        auto folder = TemporaryFolder::create();
        if (!folder) return folder.error();
        const std::filesystem::path state = folder->path() / "state.xml",
                                    script = folder->path() / "script.xml";
        const int port = freePort();
        for (const auto& [file, text] :
             {std::pair(state, jsbsimStateText(start)),
              std::pair(script, jsbsimScriptText(data, start, state, port, ChildProcess::kPipeInChild,
                                                 kStepsPerSecond))})
            if (const auto written = foundation::writeWholeFile(file, text); !written) return written.error();
        const std::filesystem::path root = std::filesystem::absolute(data.root);
        auto child = ChildProcess::start(
            {data.program,
             {"--root=" + root.string(), "--script=" + script.string(), "--suspend", "--nohighlight"},
             folder->path() / "output"});
        if (!child) return child.error();
        std::unique_ptr<JsbsimProcess> process(
            new JsbsimProcess(data, start.asked, std::move(*folder), std::move(*child)));
        const auto opened = process->open(port);
        if (opened) return process;
        last = opened.error();
        if (!jsbsimLostItsPort(process->_folder.path() / "output")) break;
    }
    return last;
}

/// Waits until it listens, and makes the first step: a row of the pipe proves that the port is this child's.
foundation::Outcome JsbsimProcess::open(int port)
{
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(_data.beginsWithinS);
    for (_socket = connectTo(port); _socket < 0; _socket = connectTo(port))
    {
        if (!_child.isRunning()) return refusal("JSBSim " + _child.ending());
        if (Clock::now() > end) return refusal("JSBSim did not open its port");
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    _replies = TimedReader(_socket);
    std::string greeting, line;
    if (_replies.until(kPrompt, _patienceS, greeting) != ReadEnd::complete)
        return refusal("JSBSim does not greet");
    if (_rows.until("\n", _patienceS, line) != ReadEnd::complete) return refusal("JSBSim tells no columns");
    _table = JsbsimTable::create(line, _asked);
    if (!_table)
        return refusal("JSBSim tells columns that are not those asked for: " + foundation::excerpt(line));
    switch (readFirstRow())
    {
    case JsbsimFault::none:
        break;
    case JsbsimFault::late:
        return refusal("JSBSim did not answer in time");
    case JsbsimFault::ended:
        _child.isRunning();
        return refusal("JSBSim " + (_child.ending().empty() ? "closed its connection" : _child.ending()));
    default:
        return refusal("JSBSim answered what cannot be used");
    }
    if (jsbsimLostItsPort(_folder.path() / "output")) return refusal("JSBSim lost its port");
    _patienceS = _data.answersWithinS;
    return foundation::success();
}

/// The row of the first step; one before it, at the time 0, is passed over. A JSBSim that waits for orders
/// gets one.
JsbsimFault JsbsimProcess::readFirstRow()
{
    constexpr double kOrderedAfterS = 0.2;
    constexpr int kMostRows = 100;
    double waitedS = 0.0;
    for (int rows = 0; rows < kMostRows && waitedS < _data.beginsWithinS; ++rows)
    {
        _patienceS = kOrderedAfterS;
        bool hasMoved = false;
        const JsbsimFault fault = readRow(hasMoved);
        if (fault == JsbsimFault::none && !hasMoved) continue;
        if (fault != JsbsimFault::late) return fault;
        waitedS += kOrderedAfterS;
        if (!send("iterate 1\n")) return JsbsimFault::ended;
    }
    return waitedS > 0.0 ? JsbsimFault::late : JsbsimFault::outOfStep;
}

foundation::Error JsbsimProcess::refusal(const std::string& what)
{
    const std::string words = jsbsimLastWords(_folder.path() / "output");
    return {_data.name, words.empty() ? what : what + ": " + words, "try the aircraft in JSBSim alone"};
}

bool JsbsimProcess::send(const std::string& text)
{
    return ::send(_socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
           static_cast<ssize_t>(text.size());
}

std::optional<double> JsbsimProcess::value(const std::string& property) const
{
    const auto at = std::find(_asked.begin(), _asked.end(), property);
    if (at == _asked.end() || _row.more.empty()) return std::nullopt;
    const std::optional<double>& number = _row.more[static_cast<std::size_t>(at - _asked.begin())];
    return number && std::isfinite(*number) ? number : std::nullopt;
}

JsbsimFault JsbsimProcess::order(const std::string& orders, bool& hasMoved)
{
    // Nothing waits for the replies: they would come late, and say nothing that is not known.
    _replies.discard();
    if (!send(orders + "iterate 1\n")) return _child.isRunning() ? JsbsimFault::late : JsbsimFault::ended;
    return readRow(hasMoved);
}

JsbsimFault JsbsimProcess::advance(const std::string& orders)
{
    bool hasMoved = false;
    // The first order only wakes it: it writes its last row again.
    if (_isHeld)
        if (const JsbsimFault fault = order({}, hasMoved); fault != JsbsimFault::none || hasMoved)
            return fault;
    _isHeld = false;
    const JsbsimFault fault = order(orders, hasMoved);
    return fault == JsbsimFault::none && !hasMoved ? JsbsimFault::outOfStep : fault;
}

/// Reads a row. `hasMoved`: its time has gone on by one step; else it is that of the last one.
JsbsimFault JsbsimProcess::readRow(bool& hasMoved)
{
    std::string line;
    switch (_rows.until("\n", _patienceS, line))
    {
    case ReadEnd::complete:
        break;
    case ReadEnd::late:
        return JsbsimFault::late;
    case ReadEnd::closed:
        return JsbsimFault::ended;
    case ReadEnd::tooLong:
        return JsbsimFault::unreadable;
    }
    const std::optional<JsbsimRow> row = _table->read(line);
    if (!row) return JsbsimFault::unreadable;
    if (!row->isFinite()) return JsbsimFault::notFinite;
    const double steps = ((*row)[JsbsimColumn::time] - _row[JsbsimColumn::time]) / kStepS;
    hasMoved = std::abs(steps - 1.0) < 0.1;
    if (!hasMoved && std::abs(steps) > 0.1) return JsbsimFault::outOfStep;
    _row = *row;
    return JsbsimFault::none;
}

} // namespace simulation
