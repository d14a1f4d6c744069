// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/programmerbox.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"

#include <QComboBox>

#include <algorithm>

namespace mb {

ProgrammerBox::ProgrammerBox(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    m_programmer = makeBox(this, tr("Programmer"),
        tr("What writes the flash: one of the list, or the name that the program gives to another"));
    m_programmer->setObjectName(QStringLiteral("programmer"));
    m_programmer->setMinimumWidth(theme.theme().u(140));
    m_port = makeBox(
        this, tr("Port of the programmer"), tr("Where the programmer, or the line to the bootloader, is plugged in"));
    m_port->setObjectName(QStringLiteral("programmerPort"));
    m_port->setMinimumWidth(theme.theme().u(180));
    m_at = textLabel(tr("at"), TextRole::Body, Tone::Dim, this);
    auto *row = layoutIn<QHBoxLayout>(this, theme.theme().u(8));
    row->addWidget(m_programmer, 2);
    row->addWidget(m_at);
    row->addWidget(m_port, 3);
    connect(m_programmer, &QComboBox::currentTextChanged, this, &ProgrammerBox::followProgrammer);
    connect(m_port, &QComboBox::currentTextChanged, this, &ProgrammerBox::changed);
}

/// A list whose entries are chosen, or another thing is typed: the data of an entry is what is meant.
QComboBox *ProgrammerBox::makeBox(QWidget *parent, const QString &name, const QString &help)
{
    auto *box = new QComboBox(parent);
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setAccessibleName(name);
    box->setToolTip(help);
    return box;
}

void ProgrammerBox::show(const UpdateRoute &route)
{
    m_route = &route;
    const QSignalBlocker quiet(m_programmer);
    m_programmer->clear();
    for (const Programmer &programmer : route.programmers)
        m_programmer->addItem(
            QStringLiteral("%1 (%2)").arg(tableText(programmer.title), qt(programmer.name)), qt(programmer.name));
    followProgrammer();
}

void ProgrammerBox::listPorts(const std::vector<LinkListing> &listings, const std::string &own)
{
    std::vector<std::pair<QString, QString>> ports;
    for (const LinkListing &listing : listings) {
        if (listing.kind == LinkKind::Serial && !listing.link.path.empty())
            ports.emplace_back(qt(listing.link.path), messageText(listing.detail));
    }
    const auto address = LinkAddress::parse(own);
    const QString first = address && address->scheme == "serial" ? qt(address->path) : QString();
    std::stable_partition(ports.begin(), ports.end(), [&first](const auto &port) { return port.first == first; });
    if (!first.isEmpty() && (ports.empty() || ports.front().first != first))
        ports.emplace(ports.begin(), first, tr("the device's own line"));
    if (ports == m_ports)
        return;
    const QString kept = m_ports.empty() ? QString() : chosen(*m_port);
    m_ports = ports;
    {
        const QSignalBlocker quiet(m_port);
        m_port->clear();
        for (const auto &[path, text] : ports)
            m_port->addItem(text.isEmpty() ? path : QStringLiteral("%1 · %2").arg(path, text), path);
        if (const int place = m_port->findData(kept); place >= 0)
            m_port->setCurrentIndex(place);
        else if (!kept.isEmpty())
            m_port->setEditText(kept);
    }
    Q_EMIT changed();
}

/// What is meant by the text: the data of the entry that it is, or the text itself.
QString ProgrammerBox::chosen(const QComboBox &box)
{
    const QString text = box.currentText().trimmed();
    const int place = box.findText(text, Qt::MatchFixedString);
    return place >= 0 ? box.itemData(place).toString() : text;
}

/// Of a programmer that is not listed: as most of the program's.
Programmer::Port ProgrammerBox::portKind() const
{
    const auto &all = m_route->programmers;
    const std::string name = chosen(*m_programmer).toStdString();
    const auto known = std::ranges::find(all, name, &Programmer::name);
    if (known != all.end())
        return known->port;
    const bool anyPort = std::ranges::any_of(all, [](const Programmer &p) { return p.port != Programmer::Port::None; });
    return anyPort ? Programmer::Port::Serial : Programmer::Port::None;
}

void ProgrammerBox::followProgrammer()
{
    if (!m_route)
        return;
    const Programmer::Port kind = portKind();
    m_at->setVisible(kind != Programmer::Port::None);
    m_at->setText(kind == Programmer::Port::Usb ? tr("at USB") : tr("at"));
    m_port->setVisible(kind == Programmer::Port::Serial);
    Q_EMIT changed();
}

QString ProgrammerBox::via() const
{
    const QString named = qt(m_route->scheme) + QLatin1Char(':') + chosen(*m_programmer);
    switch (portKind()) {
    case Programmer::Port::Usb: return named + QStringLiteral(":usb");
    case Programmer::Port::Serial: return named + QLatin1Char(':') + chosen(*m_port);
    case Programmer::Port::None: break;
    }
    return named;
}

QString ProgrammerBox::missing() const
{
    if (chosen(*m_programmer).isEmpty())
        return tr("Choose a programmer");
    if (portKind() == Programmer::Port::Serial && chosen(*m_port).isEmpty())
        return tr("No serial port is plugged in; choose or name the one of the programmer");
    return {};
}

} // namespace mb
