// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSocketNotifier>

#include <array>
#include <memory>
#include <string>

#include <fcntl.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

namespace mb::test {

/// A serial adapter with one cable, which hands plug from one board into the next while the program has its port open.
class Cable {
public:
    Cable()
    {
        std::array<char, 64> name{};
        termios settings{};
        ::cfmakeraw(&settings);
        if (::openpty(&m_adapter, &m_port, name.data(), &settings, nullptr) != 0)
            qFatal("no pseudo terminal");
        ::fcntl(m_adapter, F_SETFL, O_NONBLOCK);
        m_path = name.data();
        m_fromProgram = std::make_unique<QSocketNotifier>(m_adapter, QSocketNotifier::Read);
        QObject::connect(m_fromProgram.get(), &QSocketNotifier::activated, [this] { carry(m_adapter, m_board); });
    }
    Cable(const Cable &) = delete;
    Cable &operator=(const Cable &) = delete;
    ~Cable()
    {
        unplug();
        m_fromProgram.reset();
        ::close(m_port);
        ::close(m_adapter);
    }
    /// What the program opens.
    [[nodiscard]] const std::string &path() const { return m_path; }
    /// Into the serial line of a board.
    void plug(const std::string &line)
    {
        unplug();
        m_board = ::open(line.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
        termios settings{};
        ::tcgetattr(m_board, &settings);
        ::cfmakeraw(&settings);
        if (m_board < 0 || ::tcsetattr(m_board, TCSANOW, &settings) != 0)
            qFatal("no board at %s", line.c_str());
        m_fromBoard = std::make_unique<QSocketNotifier>(m_board, QSocketNotifier::Read);
        QObject::connect(m_fromBoard.get(), &QSocketNotifier::activated, [this] { carry(m_board, m_adapter); });
    }

private:
    void unplug()
    {
        m_fromBoard.reset();
        if (m_board >= 0)
            ::close(m_board);
        m_board = -1;
    }
    static void carry(int from, int to)
    {
        std::array<char, 512> bytes{};
        const ssize_t count = ::read(from, bytes.data(), bytes.size());
        if (count > 0 && to >= 0 && ::write(to, bytes.data(), static_cast<std::size_t>(count)) != count)
            qFatal("the cable is full");
    }

    int m_adapter = -1;
    int m_port = -1; ///< held open, so that the adapter lives while the program does not use it
    int m_board = -1;
    std::string m_path;
    std::unique_ptr<QSocketNotifier> m_fromProgram;
    std::unique_ptr<QSocketNotifier> m_fromBoard;
};

} // namespace mb::test
