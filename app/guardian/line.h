// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/port.h"

#include <memory>
#include <string>

namespace mb::guardian {

/// Which line a guardian serves, as its program tells it on the command line.
struct Whereabouts {
    PortForm form = PortForm::Stream;
    std::string identity; ///< of the link: a place of hardware, or scheme and name
    std::string name;     ///< of today: can0, /dev/ttyUSB0, the path of a socket
};

/// The line behind the inherited descriptor. Once that is dead it is closed at once, so that what is plugged in again gets its old
/// name, and the line can be opened anew, under whatever name the same hardware has then.
class Line final : public Port {
public:
    Line(Whereabouts where, int descriptor);
    ~Line() override;

    /// −1 while it is closed.
    [[nodiscard]] int descriptor() const { return m_descriptor; }
    /// False while it is not there. Opening an open one does nothing.
    bool reopen();
    /// The program has ended: a terminal that it had for itself would stay closed to everybody else while it is open here.
    void share() const;

    Sent send(std::span<const std::uint8_t> bytes) override;
    Bytes read() override;
    void prepare() override;
    /// Rate and format of a terminal, mode and speed of SPI.
    void keepSetup() override;
    void restoreSetup() override;
    void forget() override;
    [[nodiscard]] std::size_t messageSize() const override;
    /// What can be read when an answer comes. On CAN a socket of its own: the inherited one has what the program has not read yet, and
    /// what is read there is missing to the program when it thaws.
    [[nodiscard]] int ear() const { return m_ear >= 0 ? m_ear : m_descriptor; }

private:
    struct Setup;
    [[nodiscard]] int openNow() const;
    void close();
    void closeEar();

    Whereabouts m_where;
    int m_descriptor;
    int m_ear = -1;
    std::unique_ptr<Port> m_port;
    std::unique_ptr<Setup> m_setup;
};

} // namespace mb::guardian
