// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/doctorcard.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"

#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>

namespace mb {

DoctorCard::DoctorCard(Workbench &workbench, const ThemeSource &theme, bool all, QWidget *parent)
    : Card(theme, tr("Connection doctor"), parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_all(all)
{
    setObjectName(QStringLiteral("connectionDoctor"));
    setAccessibleName(tr("Connection doctor"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    if (all)
        addHeadWidget(textLabel(tr("looks by itself"), TextRole::Caption, Tone::Dim, this));
    auto *rows = new QWidget(this);
    m_column = layoutIn<QVBoxLayout>(rows, theme.theme().u(12));
    body().addWidget(rows);
    setVisible(all);
}

std::vector<DoctorCard::Row> DoctorCard::rows() const
{
    std::vector<Row> rows;
    const Snapshot &shot = m_workbench.snapshot();
    for (const LinkView &link : shot.links) {
        if (!link.diagnosis.isHealthy())
            rows.push_back({link.address, {}, link.diagnosis, link.state == LinkState::Lost});
    }
    const auto failed = [&shot](const std::string &address) {
        return std::ranges::any_of(shot.failed, [&address](const FailedLink &link) { return link.address == address; });
    };
    for (const FailedLink &link : shot.failed)
        rows.push_back({link.address, {}, link.diagnosis, true});
    for (const LinkListing &listing : m_workbench.listings()) {
        if (failed(listing.link.text()))
            continue;
        const bool absent = listing.link.path.empty() && !shot.links.empty();
        if (shot.link(listing.link.text()) || absent || (!m_all && listing.diagnosis.isHealthy()))
            continue;
        // What is wrong with the other ports is told where links are added.
        if (!m_all && listing.link.scheme != "socketcan")
            continue;
        const std::string address = listing.link.path.empty() ? std::string() : listing.link.text();
        rows.push_back({address, listing.detail, listing.diagnosis, false});
    }
    return rows;
}

void DoctorCard::follow()
{
    std::vector<Row> now = rows();
    setVisible(m_all || !now.empty());
    if (m_built && now == m_rows)
        return;
    m_rows = std::move(now);
    m_built = true;
    build();
}

void DoctorCard::build()
{
    while (QLayoutItem *item = m_column->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const Row &row : m_rows)
        m_column->addWidget(makeRow(row));
    if (m_rows.empty())
        m_column->addWidget(makeRow({{}, {},
            {Ailment::NotThere, say("there is no CAN interface"),
                say("plug in an adapter at any time; it is opened by itself once it is up"), {}},
            false}));
}

QWidget *DoctorCard::makeRow(const Row &row)
{
    const int gap = m_theme.theme().u(12);
    auto *widget = new QWidget(this);
    auto *grid = layoutIn<QGridLayout>(widget);
    grid->setHorizontalSpacing(gap);
    grid->setVerticalSpacing(m_theme.theme().u(4));
    const bool healthy = row.diagnosis.isHealthy();
    grid->addWidget(new StateGlyph(m_theme, healthy ? GlyphState::Done : GlyphState::Warning, widget), 0, 0);
    const QString title = row.link.empty() ? tr("CAN") : QString::fromStdString(row.link);
    grid->addWidget(textLabel(title, TextRole::Emphasis, Tone::Text, widget), 0, 1);
    const QString says
        = healthy ? messageText(row.text) : messageText(joined(row.diagnosis.cause, row.diagnosis.remedy));
    auto *text = textLabel(says, TextRole::Body, Tone::Dim, widget);
    text->setWordWrap(true);
    grid->addWidget(text, 1, 1);
    if (!row.diagnosis.command.empty()) {
        auto *command = textLabel(QString::fromStdString(row.diagnosis.command), TextRole::Raw, Tone::Text, widget);
        command->setWordWrap(true);
        command->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        command->setAccessibleName(tr("Command for a terminal"));
        grid->addWidget(command, 2, 1);
    }
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(m_theme.theme().u(8));
    addButtons(*buttons, row, *widget);
    grid->addLayout(buttons, 0, 2, 2, 1, Qt::AlignTop);
    grid->setColumnStretch(1, 1);
    widget->setAccessibleName(title + QStringLiteral(": ") + says);
    return widget;
}

void DoctorCard::addButtons(QHBoxLayout &place, const Row &row, QWidget &parent)
{
    if (!row.diagnosis.command.empty()) {
        auto *button = new CommandButton(m_theme, Symbol::Copy, tr("Copy command"), &parent);
        button->setToolTip(tr("Paste it into a terminal; this program never runs as root"));
        connect(button, &QPushButton::clicked, this, [this, command = row.diagnosis.command] { copy(command); });
        place.addWidget(button);
    }
    if (!row.reconnect)
        return;
    auto *button = new CommandButton(m_theme, Symbol::Refresh, tr("Reconnect"), &parent);
    button->setToolTip(tr("Open this link now"));
    connect(button, &QPushButton::clicked, this, [this, link = row.link] {
        if (const auto address = LinkAddress::parse(link))
            m_workbench.send(orders::OpenLink{*address});
    });
    place.addWidget(button);
}

void DoctorCard::copy(const std::string &command)
{
    QGuiApplication::clipboard()->setText(QString::fromStdString(command));
    m_workbench.report(Severity::Info, {}, tr("The command is in the clipboard; paste it into a terminal."));
}

} // namespace mb
