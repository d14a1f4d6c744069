// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/linkcatalog.h"

#include <QString>

#include <vector>

namespace mb {

/// What the dialog "Add a link" offers to choose from.
struct LinkChoice {
    enum class Kind { Can, Serial, Spi, Recording, Simulated };
    Kind kind = Kind::Can;
    QString name;        ///< "can0", "FTDI FT232R, serial number A50285BI"
    QString state;       ///< one or two words, for people
    QString words;       ///< what it is, or why it cannot be opened and what helps
    QString command;     ///< for a terminal, where one helps
    std::string address; ///< without options; empty where a file is asked for
    bool openable = true;
    bool isOpen = false; ///< it is in use here already

    /// It may be open by now, or not there any more.
    [[nodiscard]] bool isSameAs(const LinkChoice &other) const
    {
        return kind == other.kind && address == other.address;
    }
    friend bool operator==(const LinkChoice &, const LinkChoice &) = default;
};

/// A row for every interface, port and device of `listings`, then a recording and the simulated links. `open`: addresses of the
/// links that are open.
[[nodiscard]] std::vector<LinkChoice> linkChoices(
    const std::vector<LinkListing> &listings, const std::vector<std::string> &open);
/// "CAN interfaces", "Serial ports" …
[[nodiscard]] QString kindTitle(LinkChoice::Kind kind);

} // namespace mb
